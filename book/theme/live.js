// Live pictures: below a figure stands a button, and then the chapters' own code computes the picture here.
(() => {
    "use strict";

    const WORKERS = Math.max(1, Math.min(navigator.hardwareConcurrency || 1, 4));
    // Pixels along the longer side while something is being moved.
    const PREVIEW_SIDE = 320;
    // Milliseconds of rest after which the full picture begins.
    const REST = 250;
    const DEGREES_PER_PIXEL = 0.25;

    const make = (name, properties, ...children) => {
        const element = Object.assign(document.createElement(name), properties);
        element.append(...children);
        return element;
    };

    // What each worker runs, with an instance of the module of its own. It stands here as a function, and travels as
    // text: a page that was opened from disk may not load the file of a worker.
    function work() {
        const SLICE = 30;
        let module, code, job, timer;
        const text = (length) => new TextDecoder().decode(new Uint8Array(code.memory.buffer, code.text(), length));

        const begin = () => {
            code ??= new WebAssembly.Instance(module).exports;
            if (text(code.make_description(job.chapter, job.picture)) !== job.description) {
                throw new Error("this page and its live pictures were made from different sources: build the book again");
            }
            code.choose(job.chapter, job.picture);
            job.values.forEach((value, knob) => code.turn(knob, value));
            const problem = code.start(job.width, job.height, job.samples, job.worker, job.workers);
            if (problem > 0) {
                throw new Error(text(problem));
            }
        };
        const slice = () => {
            const end = performance.now() + SLICE;
            const tiles = [];
            let more;
            do {
                more = code.step() === 1;
                if (more) {
                    const bytes = new Uint8ClampedArray(code.memory.buffer, code.pixels(), code.pixels_length()).slice();
                    tiles.push({ left: code.tile_left(), top: code.tile_top(), width: code.tile_width(), bytes });
                }
            } while (more && performance.now() < end);
            const report = { number: job.number, worker: job.worker, tiles, samples: code.samples(), more };
            report.bad = more ? 0 : code.bad_samples();
            postMessage(report, tiles.map((tile) => tile.bytes.buffer));
            if (more) {
                timer = setTimeout(attempt, 0, slice);
            }
        };
        // After a panic nothing in an instance can be relied upon but the text.
        const attempt = (task) => {
            try {
                task();
            } catch (error) {
                const panic = error instanceof WebAssembly.RuntimeError ? text(code.text_length()) : "";
                code = undefined;
                clearTimeout(timer);
                postMessage({ number: job.number, error: panic || error.message });
            }
        };
        onmessage = ({ data }) => {
            module ??= data.module;
            if (data.job) {
                job = data.job;
                clearTimeout(timer);
                attempt(() => {
                    begin();
                    slice();
                });
            }
        };
    }

    // The module is loaded when it is first wanted, and once.
    const modules = {};
    const load = (address) => {
        modules[address] ??= new Promise((resolve, reject) => {
            window.courseModule = (text) => {
                const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
                WebAssembly.compile(bytes).then(resolve, reject);
            };
            const onerror = () => reject(new Error(`${address} cannot be loaded`));
            document.head.append(make("script", { src: address, onerror }));
        });
        modules[address].catch(() => delete modules[address]);
        return modules[address];
    };

    // A knob as a labelled input; `changed` is told of every new value, `show` puts a value into the input.
    const control = (knob, changed) => {
        const value = make("output");
        const label = [make("b", {}, knob.name), " ", make("span", { className: "what" }, knob.what)];
        if (knob.kind === "switch") {
            const input = make("input", { type: "checkbox", oninput: () => changed(Number(input.checked)) });
            const show = (value) => (input.checked = value !== 0);
            return { row: make("label", { className: "switch" }, input, make("span", {}, ...label)), show };
        }
        if (knob.kind === "choice") {
            const options = knob.options.map((option) => make("option", {}, option));
            const input = make("select", { oninput: () => changed(input.selectedIndex) }, ...options);
            const show = (value) => (input.selectedIndex = value);
            return { row: make("label", {}, make("span", {}, ...label), input), show };
        }
        // The slider counts steps from the default, so that each press of an arrow key is one step.
        const { min, max, step, scale } = knob;
        const isScaled = scale === "times" && knob.default > 0;
        const steps = (value) =>
            isScaled ? Math.log(value / knob.default) / Math.log(step) : (value - knob.default) / step;
        const at = (count) => {
            const value = isScaled ? knob.default * step ** count : knob.default + step * count;
            const rounded = isScaled ? Number(value.toPrecision(4)) : Math.round(value * 1e4) / 1e4;
            return count === 0 ? knob.default : Math.min(Math.max(rounded, min), max);
        };
        const least = isScaled && min <= 0 ? -100 : Math.floor(steps(min) + 1e-6);
        const input = make("input", { type: "range", min: least, max: Math.ceil(steps(max) - 1e-6) });
        const show = (number) => {
            input.value = Math.round(steps(number));
            const unit = knob.unit === "" || knob.unit === "°" ? knob.unit : ` ${knob.unit}`;
            value.value = Number(number.toPrecision(4)) + unit;
            input.setAttribute("aria-valuetext", value.value);
        };
        input.oninput = () => changed(at(Number(input.value)));
        return { row: make("label", {}, make("span", {}, ...label), value, input), show };
    };

    // The picture in the place of the pinned one, until it is stopped.
    const open = (place, module, stopped) => {
        const figure = place.closest("figure");
        const pinned = figure.querySelector("a");
        const image = pinned.querySelector("img");
        const description = place.dataset.picture;
        const picture = JSON.parse(description);
        const defaults = picture.knobs.map((knob) => knob.default);
        const index = (name) => picture.knobs.findIndex((knob) => knob.name === name);
        const [yaw, pitch, zoom] = ["yaw", "pitch", "zoom"].map(index);

        let values = [...defaults];
        let number = 0;
        let isPreview, isOutdated, isWorking, samples, running, bad, rest, frame;
        const { width, height } = picture;
        const canvas = make("canvas", { width, height, tabIndex: 0 });
        canvas.setAttribute("role", "img");
        canvas.setAttribute("aria-label", image.alt);
        canvas.style.width = `${image.getAttribute("width")}px`;
        canvas.style.aspectRatio = `${image.getAttribute("width")} / ${image.getAttribute("height")}`;
        const shown = canvas.getContext("2d", { alpha: false, willReadFrequently: true });
        // Tiles arrive here; the old picture stays in view until every tile has arrived once.
        const film = make("canvas").getContext("2d", { alpha: false, willReadFrequently: true });
        const status = make("span", { className: "status" });
        const problem = make("p", { className: "problem", hidden: true });
        problem.setAttribute("role", "alert");

        const fail = (message) => {
            isWorking = false;
            figure.dataset.live = "error";
            status.textContent = "";
            problem.textContent = `The picture cannot be computed: ${message}`;
            problem.hidden = false;
        };
        const begin = (asPreview) => {
            if (!asPreview) {
                clearTimeout(rest);
            }
            number += 1;
            [isPreview, isOutdated, isWorking, bad] = [asPreview, false, true, 0];
            [samples, running] = [Array(WORKERS).fill(0), WORKERS];
            const scale = isPreview ? Math.min(1, PREVIEW_SIDE / Math.max(width, height)) : 1;
            film.canvas.width = Math.max(1, Math.round(width * scale));
            film.canvas.height = Math.max(1, Math.round(height * scale));
            figure.dataset.live = "running";
            problem.hidden = true;
            const job = { number, description, values, workers: WORKERS, samples: isPreview ? 1 : picture.samples };
            Object.assign(job, { chapter: picture.chapter, picture: picture.picture });
            Object.assign(job, { width: film.canvas.width, height: film.canvas.height });
            workers.forEach((worker, index) => worker.postMessage({ job: { ...job, worker: index } }));
        };
        // A preview on its way is finished before the next begins, or nothing would be seen while dragging.
        const changed = () => {
            controls.forEach(({ show }, index) => show(values[index]));
            clearTimeout(rest);
            rest = setTimeout(begin, REST, false);
            if (isWorking && isPreview) {
                isOutdated = true;
            } else {
                begin(true);
            }
        };
        const draw = () => {
            frame = undefined;
            if (Math.min(...samples) > 0 || number === 1) {
                shown.drawImage(film.canvas, 0, 0, width, height);
            }
            const counted = `${Math.min(...samples)} of ${picture.samples} ${picture.samples === 1 ? "sample" : "samples"}`;
            const warning = bad > 0 ? `, ${bad} of all were no numbers` : "";
            status.textContent = isPreview ? "preview" : counted + warning;
        };
        const receive = ({ data }) => {
            if (data.number !== number || !isWorking) {
                return;
            }
            if (data.error) {
                fail(data.error);
                return;
            }
            for (const { left, top, width, bytes } of data.tiles) {
                film.putImageData(new ImageData(bytes, width), left, top);
            }
            samples[data.worker] = data.samples;
            bad += data.bad;
            running -= data.more ? 0 : 1;
            if (running > 0) {
                frame ??= requestAnimationFrame(draw);
                return;
            }
            isWorking = false;
            draw();
            if (isPreview && isOutdated) {
                begin(true);
            } else if (!isPreview) {
                figure.dataset.live = "done";
            }
        };

        const script = URL.createObjectURL(new Blob([`(${work})()`], { type: "text/javascript" }));
        const workers = Array.from({ length: WORKERS }, () => {
            const worker = new Worker(script);
            Object.assign(worker, { onmessage: receive, onerror: (event) => fail(event.message) });
            worker.postMessage({ module });
            return worker;
        });
        const stop = () => {
            workers.forEach((worker) => worker.terminate());
            clearTimeout(rest);
            cancelAnimationFrame(frame ?? 0);
            URL.revokeObjectURL(script);
            canvas.replaceWith(pinned);
            panel.remove();
            delete figure.dataset.live;
            stopped();
        };
        const reset = () => {
            values = [...defaults];
            changed();
        };

        // The camera follows the pointer; the page still scrolls unless the picture was clicked before.
        const move = (knob, value, isRound) => {
            const { min, max } = picture.knobs[knob] ?? {};
            if (knob >= 0) {
                const turned = isRound && max - min === 360 ? ((((value - min) % 360) + 360) % 360) + min : value;
                values[knob] = Math.min(Math.max(turned, min), max);
            }
        };
        const orbit = (right, down) => {
            move(yaw, values[yaw] - right * DEGREES_PER_PIXEL, true);
            move(pitch, values[pitch] + down * DEGREES_PER_PIXEL, false);
            changed();
        };
        if (yaw >= 0 || pitch >= 0) {
            canvas.classList.add("turns");
            canvas.title = "Drag to turn the camera. Click, and the wheel zooms.";
            let last;
            canvas.onpointerdown = (event) => {
                canvas.setPointerCapture(event.pointerId);
                last = event;
            };
            canvas.onpointermove = (event) => {
                const [right, down] = [event.clientX - last?.clientX, event.clientY - last?.clientY];
                if (canvas.hasPointerCapture(event.pointerId) && (right || down)) {
                    last = event;
                    orbit(right, down);
                }
            };
            // mdBook opens its list of pages when a finger is drawn to the right.
            canvas.addEventListener("touchstart", (event) => event.stopPropagation(), { passive: true });
            canvas.onkeydown = (event) => {
                const way = { ArrowLeft: [20, 0], ArrowRight: [-20, 0], ArrowUp: [0, 20], ArrowDown: [0, -20] }[event.key];
                if (way) {
                    event.preventDefault();
                    orbit(...way);
                }
            };
        }
        if (zoom >= 0) {
            const wheel = (event) => {
                if (event.ctrlKey || document.activeElement === canvas) {
                    event.preventDefault();
                    move(zoom, values[zoom] * picture.knobs[zoom].step ** -Math.sign(event.deltaY), false);
                    changed();
                }
            };
            canvas.addEventListener("wheel", wheel, { passive: false });
        }

        const controls = picture.knobs.map((knob, index) =>
            control(knob, (value) => {
                values[index] = value;
                changed();
            }),
        );
        controls.forEach(({ show }, index) => show(values[index]));
        const button = make("button", { type: "button", onclick: stop }, "Stop");
        const buttons = [button, make("button", { type: "button", onclick: reset }, "Reset")];
        const bar = make("div", { className: "bar" }, ...buttons, status);
        const knobs = make("div", { className: "knobs" }, ...controls.map(({ row }) => row));
        const panel = make("div", { className: "panel" }, bar, problem, knobs);
        // mdBook turns the page when an arrow key is pressed.
        for (const element of [canvas, panel]) {
            element.addEventListener("keydown", (event) => event.stopPropagation());
        }
        pinned.replaceWith(canvas);
        place.append(panel);
        button.focus({ preventScroll: true });
        begin(false);
    };

    for (const place of document.querySelectorAll(".live[data-module]")) {
        const problem = make("p", { className: "problem", hidden: true });
        problem.setAttribute("role", "alert");
        const run = async () => {
            button.disabled = true;
            problem.hidden = true;
            try {
                const module = await load(place.dataset.module);
                open(place, module, () => {
                    button.hidden = false;
                    button.focus({ preventScroll: true });
                });
                button.hidden = true;
            } catch (error) {
                place.closest("figure").dataset.live = "error";
                problem.textContent = `The picture cannot be computed here: ${error.message}`;
                problem.hidden = false;
            }
            button.disabled = false;
        };
        const button = make("button", { type: "button", className: "run", onclick: run }, "Run it here");
        place.append(button, problem);
    }
})();
