using Harvester.Play.Tapes;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Small tapes.</summary>
internal static class TapeBytes
{
    /// <summary>Bytes before the first chunk.</summary>
    public const int HeadBytes = 8;

    private const byte Fact = 1;

    /// <summary>The ticks of a mod that is not asked for anything.</summary>
    public static IReadOnlyList<TapeEntry> Idle { get; } =
    [
        new TapeFact(TapeFacts.Mod, "1.2.3"),
        new TapeFact(TapeFacts.Program, "GTA5.exe"),
        new TapeFact(TapeFacts.Build, "1.0.3179.0"),
        new TapeFact(TapeFacts.Settings, "[Harvest]\nWidth = 64\nHeight = 48\n"),
        new TapeTick(),
        new TapeClock(160_000),
        new TapeTick(),
        new TapeTick(),
        new TapeEnd("the script ended"),
    ];

    /// <summary>An entry of every kind.</summary>
    public static IReadOnlyList<TapeEntry> Every { get; } =
    [
        .. Idle.SkipLast(1),
        new TapeKey(73, true),
        new TapeKey(73, false),
        new TapeCall(
            0xD80958FC74E988A6,
            [TapeValue.Of(1), TapeValue.Of(1f), TapeValue.Of("a"), TapeValue.Memory(2)],
            TapeValue.Of(true),
            [
                [1, 2],
            ]
        ),
        new TapeCall(TapeLists.Peds, [TapeValue.Of(1, 2, 3), TapeValue.Of((string?)null)], TapeValue.Failed(new IOException()), []),
        new TapeWork("loading", true),
        new TapeGrab(2, 1, null, 5, [1, 2, 3, 4, 5, 6]),
        new TapeGrab(2, 1, "covered", 0, null),
        new TapeEnd("the script ended"),
    ];

    /// <summary>A tape with some entries, and others that are encoded already.</summary>
    public static byte[] Of(IEnumerable<TapeEntry> entries, params byte[][] chunks)
    {
        using var folder = new TemporaryFolder();
        string path = folder.PathOf("made.tape");
        var encoder = new TapeEncoder();
        foreach (TapeEntry entry in entries)
        {
            encoder.Add(entry);
        }

        using (var file = new TapeFile(path))
        {
            foreach (byte[] chunk in encoder.Length > 0 ? chunks.Prepend(encoder.Take()) : chunks)
            {
                file.Append(chunk);
            }
        }

        return File.ReadAllBytes(path);
    }

    /// <summary>An entry as a chunk.</summary>
    public static byte[] Encoded(TapeEntry entry)
    {
        var encoder = new TapeEncoder();
        encoder.Add(entry);
        return encoder.Take();
    }

    /// <summary>Facts without name and text, whose lengths of 0 are written in 8 and 7 bytes: nothing else of a tape limits them.</summary>
    public static byte[] Facts(int bytes)
    {
        const byte more = 0x80;
        byte[] fact = [Fact, more, more, more, more, more, more, more, 0, more, more, more, more, more, more, 0];
        byte[] facts = new byte[bytes / fact.Length * fact.Length];
        for (int i = 0; i < facts.Length; i++)
        {
            facts[i] = fact[i % fact.Length];
        }

        return facts;
    }
}
