using System.Windows.Forms;

namespace Harvester.Mod.Tests;

/// <summary>The keys under [Keys] of the shipped file, which SettingsTests compares with the mod's own.</summary>
internal static class ShippedKeys
{
    /// <summary>All of them, in the order of the file.</summary>
    public static IReadOnlyList<Keys> All { get; } =
    [
        .. File.ReadLines(Path.Combine(BuiltMod.RepositoryRoot, "src", "Harvester.Mod", "GtaDataHarvester.ini"))
            .SkipWhile(line => line != "[Keys]")
            .Skip(1)
            .TakeWhile(line => !line.StartsWith('['))
            .Where(line => line.Contains('=', StringComparison.Ordinal) && line[0] != ';')
            .Select(line => Enum.Parse<Keys>(line.Split('=')[1].Trim())),
    ];
}
