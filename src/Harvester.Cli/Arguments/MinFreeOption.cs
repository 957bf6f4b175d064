using System.CommandLine;
using Harvester.Capture.Harvesting;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Arguments;

/// <summary>--min-free: the space that stays free on the disk that is written to.</summary>
internal static class MinFreeOption
{
    /// <summary>Name of the option.</summary>
    public const string Name = "--min-free";

    private const double MaxBytes = 1e18;

    private static readonly (string Unit, double Bytes)[] Units = [("KB", 1e3), ("MB", 1e6), ("GB", 1e9), ("TB", 1e12)];

    /// <summary>Creates the option.</summary>
    public static Option<long?> Create() =>
        ValueParsers.Optional<long>(
            Name,
            "SIZE",
            "Stop in good order before less than this is free on the disk; 0 does not watch it [default: 1GB]",
            BytesOf,
            "0, or a number with KB, MB, GB or TB, e.g. 500MB"
        );

    /// <summary>The space that stays free, bytes; 0 to watch nothing.</summary>
    public static long BytesIn(ParseResult parsed, Option<long?> option) => parsed.GetValue(option) ?? HarvestOptions.DefaultMinFreeBytes;

    private static long? BytesOf(string text)
    {
        if (text == "0")
        {
            return 0;
        }

        (string unit, double size) = Units.FirstOrDefault(unit => text.EndsWith(unit.Unit, StringComparison.OrdinalIgnoreCase));
        return unit is not null && NumberText.Read(text[..^unit.Length]) is >= 0 and var number && number * size <= MaxBytes
            ? (long)(number * size)
            : null;
    }
}
