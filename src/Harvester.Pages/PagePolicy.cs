using System.Security.Cryptography;
using System.Text;

namespace Harvester.Pages;

/// <summary>
/// The content security policy of a page that a server sends: nothing but the page's own style sheet and script runs, and nothing is
/// loaded from elsewhere.
/// </summary>
public static class PagePolicy
{
    /// <summary>The value of the Content-Security-Policy header.</summary>
    /// <param name="style">Style sheet of the page, as given to <see cref="HtmlPage"/>.</param>
    /// <param name="script">The one script of the page, as given to <see cref="MarkupWriter.Code"/>; null for none.</param>
    public static string Of(string style, string? script) =>
        $"default-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'; connect-src 'self'; img-src 'self' data: blob:; "
        + $"style-src {HashOf(HtmlPage.StyleSheet(style))}; script-src {(script is null ? "'none'" : HashOf(script))}";

    /// <summary>The content of an element that <see cref="MarkupWriter.Code"/> writes, by its hash.</summary>
    private static string HashOf(string code) => $"'sha256-{Convert.ToBase64String(SHA256.HashData(Encoding.UTF8.GetBytes("\n" + code)))}'";
}
