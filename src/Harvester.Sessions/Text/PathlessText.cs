using System.Text.RegularExpressions;

namespace Harvester.Sessions.Text;

/// <summary>Messages as they are kept in files that are passed on: without the folders of the machine on which they arose.</summary>
internal static class PathlessText
{
    private static readonly Regex QuotedPath = new(
        @"'(?! )[^'\r\n]*[/\\](?<name>[^'/\\\r\n]+)[/\\]?(?<! )'",
        RegexOptions.CultureInvariant
    );

    // A drive, a share or a root folder, up to the next space or quotation mark.
    private static readonly Regex BarePath = new(
        @"(?<![^\s(""=:])(?:[A-Za-z]:[/\\]|\\\\|/)[^\s""']*?(?<name>[^\s""'/\\]*)(?=[\s""']|\z)",
        RegexOptions.CultureInvariant
    );

    /// <summary>The text with every path replaced by the name of its last part, in the quotation marks of the path.</summary>
    /// <param name="text">A message; null stays null.</param>
    public static string? Of(string? text) =>
        text is null ? null : BarePath.Replace(QuotedPath.Replace(text, static path => $"'{path.Groups["name"].Value}'"), "${name}");
}
