using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Linq;
using Harvester.Cli.Arguments;

namespace Harvester.Cli.Terminals;

/// <summary>A command line as text, by which the same command is known when it is given again.</summary>
internal static class CommandText
{
    // These do not change what is written.
    private static readonly string[] LeftOut = ["--overwrite", "--resume", "--quiet", "-q"];

    // Nor do these, which have a value.
    private static readonly string[] LeftOutWithValue = ["--out", MinFreeOption.Name];

    /// <summary>The command with its arguments, without the output folder and without what does not change the result.</summary>
    public static string Of(ParseResult parsed) => string.Join(' ', Words(parsed.Tokens).Select(ShellWord.Of).Prepend("harvester"));

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
