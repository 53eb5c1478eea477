// Runs the live pictures of one page of the book in Chromium and compares them with PNG files of the command line.
// Arguments: the browser, a folder with the PNG files (and for the browser's own files), the page.
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [browser, folder, page] = process.argv.slice(2);
const flags = `--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking
    --disable-component-update --disable-sync --hide-scrollbars --window-size=1280,1000 --force-color-profile=srgb
    --remote-debugging-pipe --user-data-dir=${folder}/profile about:blank`;
const chromium = spawn(browser, flags.split(/\s+/), { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
process.on("exit", () => chromium.kill("SIGKILL"));
chromium.on("error", (error) => fail(`${browser} does not start: ${error.message}`));
chromium.on("exit", () => fail(`${browser} has ended`));

// The DevTools protocol: JSON with a zero byte behind each message.
const waiting = new Map();
const problems = [];
let last = 0;
let buffer = Buffer.alloc(0);
chromium.stdio[4].on("data", (data) => {
    buffer = Buffer.concat([buffer, data]);
    for (let end = buffer.indexOf(0); end >= 0; end = buffer.indexOf(0)) {
        receive(JSON.parse(buffer.subarray(0, end).toString()));
        buffer = buffer.subarray(end + 1);
    }
});

function send(method, params = {}, sessionId = undefined) {
    const id = ++last;
    chromium.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => waiting.set(id, { resolve, reject }));
}

function receive({ id, method, params, result, error, sessionId }) {
    if (id) {
        const { resolve, reject } = waiting.get(id);
        waiting.delete(id);
        error ? reject(new Error(error.message)) : resolve(result);
    } else if (method === "Target.attachedToTarget") {
        watch(params.sessionId);
    } else if (method === "Runtime.exceptionThrown") {
        problems.push(`exception: ${params.exceptionDetails.exception?.description ?? params.exceptionDetails.text}`);
    } else if (method === "Runtime.consoleAPICalled" || method === "Log.entryAdded") {
        const text = params.entry?.text ?? params.args.map((a) => a.value ?? a.description).join(" ");
        problems.push(`console: ${text}`);
    } else if (method === "Network.requestWillBeSent" && !/^(file|blob|data|about):/.test(params.request.url)) {
        problems.push(`request: ${params.request.url}`);
    }
}

// The page and each of its workers is watched.
function watch(session) {
    for (const method of ["Runtime.enable", "Log.enable", "Network.enable"]) {
        // A worker has no log of its own.
        send(method, {}, session).catch(() => {});
    }
    send("Target.setAutoAttach", { autoAttach: true, waitForDebuggerOnStart: false, flatten: true }, session).catch(() => {});
}

function fail(message) {
    console.error(`error: ${message}`);
    process.exit(1);
}

function check(condition, message) {
    if (!condition) {
        fail([message, ...problems].join("\n"));
    }
}

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

const { targetId } = await send("Target.createTarget", { url: "about:blank" });
const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
const evaluate = async (expression) => {
    const options = { expression, awaitPromise: true, returnByValue: true };
    const { result, exceptionDetails } = await send("Runtime.evaluate", options, sessionId);
    check(!exceptionDetails, `${expression}: ${exceptionDetails?.exception?.description}`);
    return result.value;
};
const until = async (expression, what) => {
    for (const end = Date.now() + 60_000; Date.now() < end; await pause(50)) {
        if (await evaluate(expression)) {
            return;
        }
    }
    fail([`${what}: waited for a minute`, ...problems].join("\n"));
};
const mouse = (type, x, y, more = {}) =>
    send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons: 1, ...more }, sessionId);

await send("Page.enable", {}, sessionId);
await send("Page.navigate", { url: pathToFileURL(page).href }, sessionId);
await until("document.readyState === 'complete' && document.querySelectorAll('.live .run').length > 1", "the buttons");

// Helpers inside the page.
await evaluate(`
    window.figure = (name) => document.querySelector(\`[data-picture*='"ray-casting/\${name}"']\`).closest("figure");
    window.pixels = (canvas) => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    window.hash = async (name) => {
        const digest = await crypto.subtle.digest("SHA-256", pixels(figure(name).querySelector("canvas")));
        return [...new Uint8Array(digest)].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    };
    window.differing = async (name, url) => {
        const image = new Image();
        image.src = url;
        await image.decode();
        const { width, height } = figure(name).querySelector("canvas");
        if (image.width !== width || image.height !== height) {
            return \`the size is \${width}x\${height} instead of \${image.width}x\${image.height}\`;
        }
        const canvas = Object.assign(document.createElement("canvas"), { width, height });
        canvas.getContext("2d").drawImage(image, 0, 0);
        const [expected, found] = [pixels(canvas), pixels(figure(name).querySelector("canvas"))];
        return expected.filter((byte, index) => byte !== found[index]).length;
    };
    window.longest = 0;
    let before = performance.now();
    const frame = (now) => {
        window.longest = Math.max(window.longest, now - before);
        before = now;
        requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
    true`);

for (const name of ["sphere", "far-sphere"]) {
    await evaluate(`figure("${name}").scrollIntoView({ block: "center", behavior: "instant" })`);
    await pause(200);
    await evaluate(`window.longest = 0; figure("${name}").querySelector(".run").click()`);
    const started = Date.now();
    await until(`figure("${name}").dataset.live === "done"`, `${name} becomes done`);
    const [took, gap] = [Date.now() - started, await evaluate("window.longest")];
    const png = readFileSync(`${folder}/${name}.png`).toString("base64");
    const differing = await evaluate(`differing("${name}", "data:image/png;base64,${png}")`);
    check(differing === 0, `${name}: ${differing} bytes are not those of the command line`);
    console.log(`${name}: as on the command line, after ${took} ms; longest gap between two frames ${Math.round(gap)} ms`);
}

// A slider changes the picture, Reset brings it back.
const first = await evaluate("hash('far-sphere')");
await evaluate(`
    const slider = figure("far-sphere").querySelector("input[type=range]");
    slider.value = Number(slider.value) - 5;
    slider.dispatchEvent(new Event("input"))`);
await until("figure('far-sphere').dataset.live === 'done'", "the picture after the slider");
check((await evaluate("hash('far-sphere')")) !== first, "the slider does not change the picture");
await evaluate("[...figure('far-sphere').querySelectorAll('button')].find((b) => b.textContent === 'Reset').click()");
await until("figure('far-sphere').dataset.live === 'done'", "the picture after the reset");
check((await evaluate("hash('far-sphere')")) === first, "Reset does not bring the picture back");

// Dragging turns the camera, the wheel zooms only where the picture was clicked.
const sphere = await evaluate("hash('sphere')");
await evaluate("figure('sphere').scrollIntoView({ block: 'center', behavior: 'instant' })");
const [x, y] = await evaluate(`
    (() => {
        const { left, top, width, height } = figure("sphere").querySelector("canvas").getBoundingClientRect();
        return [left + width / 2, top + height / 2];
    })()`);
const label = (knob) => `[...figure("sphere").querySelectorAll("label")].find((l) => l.querySelector("b").textContent === "${knob}")`;
const value = (knob) => evaluate(`${label(knob)}.querySelector("output").value`);
await evaluate("document.activeElement.blur()");
const at = await evaluate("scrollY");
await mouse("mouseWheel", x, y, { deltaX: 0, deltaY: 60, button: "none", buttons: 0 });
await until(`scrollY !== ${at}`, "the page scrolls by the wheel");
check((await value("zoom")) === "1 times", "the wheel zooms although the picture was not clicked");
await evaluate(`scrollTo({ top: ${at}, behavior: "instant" })`);
await mouse("mousePressed", x, y, { clickCount: 1 });
await mouse("mouseMoved", x - 20, y);
await mouse("mouseMoved", x - 40, y + 20);
await mouse("mouseReleased", x - 40, y + 20);
check((await value("yaw")) === "10°" && (await value("pitch")) === "5°", `dragging turns to ${await value("yaw")}`);
await mouse("mouseWheel", x, y, { deltaX: 0, deltaY: -60, button: "none", buttons: 0 });
await until(`${label("zoom")}.querySelector("output").value === "1.1 times"`, "the wheel zooms");
await until("figure('sphere').dataset.live === 'done'", "the picture after dragging");
check((await evaluate("hash('sphere')")) !== sphere, "dragging does not change the picture");

// The arrow keys move a slider, turn the camera, and do not turn the page.
await evaluate("window.isHere = true");
for (const [focused, yaw] of [[`${label("yaw")}.querySelector("input")`, "15°"], ["figure('sphere').querySelector('canvas')", "20°"]]) {
    await evaluate(`${focused}.focus()`);
    const arrow = { key: "ArrowRight", code: "ArrowRight", windowsVirtualKeyCode: 39 };
    await send("Input.dispatchKeyEvent", { type: "keyDown", ...arrow }, sessionId);
    await send("Input.dispatchKeyEvent", { type: "keyUp", ...arrow }, sessionId);
    await pause(500);
    check(await evaluate("window.isHere"), "an arrow key turns the page");
    check((await value("yaw")) === yaw, `an arrow key turns the camera to ${await value("yaw")} instead of ${yaw}`);
}

// Stop brings the pinned picture and the button back.
await evaluate("[...figure('sphere').querySelectorAll('button')].find((b) => b.textContent === 'Stop').click()");
const stopped = await evaluate(
    "!figure('sphere').querySelector('canvas') && !!figure('sphere').querySelector('img') && !figure('sphere').dataset.live",
);
check(stopped, "Stop does not bring the pinned picture back");

// A page that does not fit its module says so in words.
await evaluate(`
    const place = figure("sphere").querySelector(".live");
    place.dataset.picture = place.dataset.picture.replace("yaw", "jaw");
    figure("sphere").querySelector(".run").click()`).catch(() => {});
const wrong = "[...document.querySelectorAll('figure .problem')].find((p) => !p.hidden)?.textContent ?? ''";
await until(`${wrong}.includes("made from different sources")`, "the message about a page that does not fit");

check(problems.length === 0, "there was something in the console or in the network");
console.log("live pictures: knobs, mouse and keys change them; nothing in the console, no network");
process.exit(0);
