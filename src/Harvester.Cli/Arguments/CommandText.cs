using System.CommandLine;
using System.CommandLine.Parsing;
using Harvester.Runs.Supervising;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Arguments;

/// <summary>A command line as text, by which the same command is known when it is given again.</summary>
internal static class CommandText
{
    private const int DigestDigits = 16;

    // These do not change what is written.
    private static readonly string[] LeftOut = ["--overwrite", "--resume", "--quiet", "-q"];

    // Nor do these, which have a value.
    private static readonly string[] LeftOutWithValue = ["--out", "--jobs", MinFreeOption.Name];

    /// <summary>The command with its arguments, without the output folder and without what does not change the result.</summary>
    public static string Of(ParseResult parsed) => Of(Words(parsed.Tokens));

    /// <summary>As <see cref="Of(ParseResult)"/>, with the output folder, for what depends on what is there.</summary>
    public static string WithOutput(ParseResult parsed, string folder) => Of([.. Words(parsed.Tokens), "--out", folder]);

    /// <summary>
    /// A command of these words. It stands in folders that may be passed on: of a path, only the last name is shown, and a digest of the
    /// whole distinguishes it from others.
    /// </summary>
    internal static string Of(IEnumerable<string> words)
    {
        string whole = TextOf(words);
        string shown = TextOf(words.Select(word => ShardText.Parse(word) is null ? word.TrimEnd('/', '\\').Split('/', '\\')[^1] : word));
        return shown == whole ? whole : $"{shown} #{FileDigest.Of(whole).Sha256[..DigestDigits]}";
    }

    private static string TextOf(IEnumerable<string> words) => string.Join(' ', words.Select(ShellWord.Of).Prepend("harvester"));

    private static IEnumerable<string> Words(IEnumerable<Token> tokens)
    {
        bool isValueLeftOut = false;
        foreach (Token token in tokens)
        {
            bool isOption = token.Type == TokenType.Option;
            bool isLeftOut = isOption && LeftOutWithValue.Contains(token.Value);
            if (!isValueLeftOut && !isLeftOut && !(isOption && LeftOut.Contains(token.Value)))
            {
                yield return token.Value;
            }

            isValueLeftOut = isLeftOut;
        }
    }
}
