using System.Globalization;

namespace Harvester.Mod.Tests.Games.Natives;

/// <summary>The natives of ref/natives.csv.</summary>
internal static class NativeTable
{
    private const int Columns = 4;

    public static IReadOnlyDictionary<ulong, NativeSignature> ByHash { get; } = Read().ToDictionary(native => native.Hash);

    private static IEnumerable<NativeSignature> Read() =>
        File.ReadLines(Path.Combine(AppContext.BaseDirectory, "natives.csv"))
            .Where(line => line.Length > 0 && line[0] != '#')
            .Skip(1)
            .Select(line => line.Split(',') is { Length: Columns } fields ? Signature(fields) : throw new InvalidDataException(line));

    private static NativeSignature Signature(string[] fields) =>
        new(
            fields[0],
            ulong.Parse(fields[1]["0x".Length..], NumberStyles.HexNumber, CultureInfo.InvariantCulture),
            new NativeType(fields[2]),
            [.. fields[3].Split(';', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries).Select(TypeOf)]
        );

    /// <summary>A parameter is its type and its name.</summary>
    private static NativeType TypeOf(string parameter) => new(parameter[..parameter.LastIndexOf(' ')]);
}
