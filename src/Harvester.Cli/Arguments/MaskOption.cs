using System.CommandLine;
using Harvester.Capture.Labelling;
using Harvester.Runs.Faults;

namespace Harvester.Cli.Arguments;

/// <summary>--masks: whether and how instance masks are made. Without a value it means rays.</summary>
internal static class MaskOption
{
    /// <summary>The methods, for the help of a command that has the option.</summary>
    public const string Notes =
        "Instance masks (--masks, docs/pixel-maps.md):\n"
        + "  rays    by rays, which hit the game's collision hulls; --masks alone means rays\n"
        + "  coded   by photographs of the frozen game in which objects are hidden in turn; with amodal masks\n"
        + "  both    by photographs, and the summary says how well masks from rays agree with them";

    private const string Rays = "rays";
    private const string Coded = "coded";
    private const string Both = "both";

    public static Option<string?> Create()
    {
        var option = new Option<string?>("--masks")
        {
            Description = "Also write instance masks, see below",
            HelpName = "METHOD",
            Arity = ArgumentArity.ZeroOrOne,
        };
        option.CompletionSources.Add(Rays, Coded, Both);
        return option;
    }

    /// <summary>The method; null without masks.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="option">The option.</param>
    /// <param name="isWhole">Whether the command harvests the whole session: masks of both methods are compared in all of it.</param>
    /// <exception cref="UsageException">The value is not a method, or cannot be used for a part of a harvest.</exception>
    public static MaskMethod? Parse(ParseResult parsed, Option<string?> option, bool isWhole) =>
        parsed.GetResult(option) is null
            ? null
            : parsed.GetValue(option)?.ToLowerInvariant() switch
            {
                null or Rays => MaskMethod.Rays,
                Coded => MaskMethod.Coded,
                Both when isWhole => MaskMethod.Both,
                Both => throw new UsageException(
                    "--masks both compares the masks of a whole harvest; use it without --shard and --resume."
                ),
                { } other => throw new UsageException($"--masks takes {Rays}, {Coded} or {Both}, not '{other}'."),
            };
}
