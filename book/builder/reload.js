// Only in pages that `cargo book --serve` hands out: asks for news, loads the page again, or shows what is wrong.
(() => {
    let box;
    setInterval(async () => {
        let text;
        try {
            text = await (await fetch("/version")).text();
        } catch {
            return; // The server has ended.
        }
        const [version, ...problem] = text.split("\n");
        if (version !== served) {
            location.reload();
        } else if (problem.join("")) {
            box ??= document.body.appendChild(document.createElement("pre"));
            box.textContent = problem.join("\n");
            box.style.cssText = "position: fixed; inset: auto 0 0 0; z-index: 999; margin: 0; padding: 1em; max-height: 40%; " +
                "overflow: auto; background: #7a1f1f; color: white; white-space: pre-wrap;";
        } else {
            box?.remove();
            box = undefined;
        }
    }, 700);
})();
