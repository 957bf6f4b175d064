using System.Globalization;
using Harvester.Pages;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Viewing;

/// <summary>The page from which one of several served sessions is chosen.</summary>
public static class ChooserPage
{
    private const string Style = """
        .sessions { display: grid; grid-template-columns: repeat(auto-fill, minmax(260px, 1fr)); gap: 16px; padding: 0; list-style: none; }
        .sessions a { display: block; padding: 12px; color: inherit; text-decoration: none; overflow-wrap: anywhere; }
        .sessions img { display: block; width: 100%; height: 150px; object-fit: cover; border-radius: 6px; background: #0b0d0f; }
        .sessions b { display: block; margin-top: 8px; }

        """;

    /// <summary>Writes the page.</summary>
    /// <param name="stream">Receives it.</param>
    /// <param name="views">The sessions; their addresses are their numbers.</param>
    /// <returns>Its content security policy.</returns>
    public static string Write(Stream stream, IReadOnlyList<SessionView> views)
    {
        ArgumentNullException.ThrowIfNull(views);
        HtmlPage.Write(stream, "Sessions", Style, page => WriteBody(page, views), isServed: true);
        return PagePolicy.Of(Style, script: null);
    }

    private static void WriteBody(MarkupWriter page, IReadOnlyList<SessionView> views)
    {
        page.Start("header").Element("h1", Counted.Of(views.Count, "session")).End();
        page.Start("ul").With("class", "sessions").NewLine();
        foreach ((int number, SessionView view) in views.Index())
        {
            string address = number.ToString(CultureInfo.InvariantCulture);
            page.Start("li").With("class", "panel").Start("a").With("href", $"{address}/");
            if (view.Frames > 0)
            {
                page.Start("img").With("src", $"{address}/image/0").With("alt", "").With("loading", "lazy").End();
            }

            page.Element("b", view.Name);
            page.Element("span", $"{Counted.Of(view.Frames, "frame")}, {view.Info.Image.Width} × {view.Info.Image.Height} px");
            page.End().End().NewLine();
        }

        page.End().NewLine();
    }
}
