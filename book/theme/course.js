// Code can be focused and scrolled with the keyboard, and then the arrow keys do not turn the page.
(() => {
    for (const box of document.querySelectorAll("main pre, main .scroll, main .table-wrapper, main .katex-display")) {
        if (box.scrollWidth > box.clientWidth || box.matches("pre")) {
            box.tabIndex = 0;
        }
        box.addEventListener("keydown", (event) => {
            if (event.key === "ArrowLeft" || event.key === "ArrowRight") {
                event.stopPropagation();
            }
        });
    }
    // The page for printing needs all its pictures before anybody scrolls to them.
    if (location.pathname.endsWith("/print.html")) {
        for (const picture of document.querySelectorAll("main img")) {
            picture.loading = "eager";
        }
    }
    // Nothing folded is missing on paper, except the hints.
    window.addEventListener("beforeprint", () => {
        for (const fold of document.querySelectorAll("main details:not(.hint)")) {
            fold.open = true;
        }
    });
})();
