namespace Harvester.Pages;

/// <summary>An SVG image in a file of its own.</summary>
public static class SvgImage
{
    private const string Namespace = "http://www.w3.org/2000/svg";

    /// <summary>Writes an image.</summary>
    /// <param name="stream">Receives UTF-8; stays open.</param>
    /// <param name="width">Width, pixels.</param>
    /// <param name="height">Height, pixels.</param>
    /// <param name="writeContent">Writes the shapes over a white background, in pixels from the upper left corner.</param>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public static void Write(Stream stream, int width, int height, Action<MarkupWriter> writeContent)
    {
        ArgumentNullException.ThrowIfNull(writeContent);
        using var svg = new MarkupWriter(stream, Namespace);
        svg.Start("svg")
            .With("viewBox", FormattableString.Invariant($"0 0 {width} {height}"))
            .With("width", width)
            .With("height", height)
            .NewLine();
        svg.Start("rect").With("width", "100%").With("height", "100%").With("fill", "#ffffff").End().NewLine();
        writeContent(svg);
        svg.End().NewLine();
    }
}
