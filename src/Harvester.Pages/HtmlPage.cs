using System.Text;

namespace Harvester.Pages;

/// <summary>An HTML page in the project's style that needs no other files and no network.</summary>
public static class HtmlPage
{
    /// <summary>Writes a page.</summary>
    /// <param name="stream">Receives UTF-8; stays open.</param>
    /// <param name="title">Title of the browser's tab.</param>
    /// <param name="style">Style sheet, in addition to the common one.</param>
    /// <param name="writeBody">Writes the content of the body element.</param>
    /// <param name="isServed">Whether a server sends the page: it then says that it has no icon, for which a browser would ask.</param>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public static void Write(Stream stream, string title, string style, Action<MarkupWriter> writeBody, bool isServed = false)
    {
        ArgumentNullException.ThrowIfNull(writeBody);
        ArgumentNullException.ThrowIfNull(stream);
        stream.Write("<!DOCTYPE html>\n"u8);
        using var page = new MarkupWriter(stream, xmlNamespace: "");
        page.Start("html").With("lang", "en").NewLine();
        page.Start("head").NewLine();
        page.Start("meta").With("charset", "utf-8").End().NewLine();
        page.Start("meta").With("name", "viewport").With("content", "width=device-width, initial-scale=1").End().NewLine();
        page.Element("title", title).NewLine();
        if (isServed)
        {
            page.Start("link").With("rel", "icon").With("href", "data:,").End().NewLine();
        }

        page.Code("style", StyleSheet(style));
        page.End().NewLine();
        page.Start("body").NewLine();
        writeBody(page);
        page.End().NewLine().End().NewLine();
    }

    /// <summary>The common style sheet with a page's own.</summary>
    internal static string StyleSheet(string style) => Asset("page.css") + style;

    private static string Asset(string name)
    {
        using Stream stream = typeof(HtmlPage).Assembly.GetManifestResourceStream($"Harvester.Pages.Assets.{name}")!;
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd().ReplaceLineEndings("\n");
    }
}
