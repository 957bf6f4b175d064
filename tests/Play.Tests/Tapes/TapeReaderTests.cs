using Harvester.Play.Tapes;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Tapes;

public sealed class TapeReaderTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory();

    /// <summary>An entry of every kind, and numbers at the ends of their ranges.</summary>
    private static readonly TapeEntry[] Every =
    [
        new TapeFact(TapeFacts.Mod, "1.2.3"),
        new TapeFact(TapeFacts.Settings, "[Harvest]\nä = €\n"),
        new TapeTick(),
        new TapeKey(73, true),
        new TapeKey(255, false),
        new TapeClock(0),
        new TapeClock(160_000),
        new TapeClock(159_999),
        new TapeClock(long.MaxValue),
        new TapeClock(long.MinValue),
        new TapeCall(ulong.MaxValue, [TapeValue.Of(int.MinValue), TapeValue.Of(int.MaxValue), TapeValue.Of(-1)], default, []),
        new TapeCall(0x12, [TapeValue.Of(float.NaN), TapeValue.Of(-0f), TapeValue.Of(1e30f, 2, 3)], TapeValue.Of(true), []),
        new TapeCall(
            0x12,
            [TapeValue.Of(""), TapeValue.Of((string?)null), TapeValue.Memory(64)],
            TapeValue.Of("a"),
            [
                [1, -1, 2],
                [],
            ]
        ),
        new TapeCall(TapeLists.Peds, [], TapeValue.Failed(new InvalidOperationException()), []),
        new TapeCall(TapeLists.Peds, [], TapeValue.Failed(new IOException()), []),
        new TapeWork("opening", false),
        new TapeWork("writing", true),
        new TapeWork("opening", true),
        new TapeGrab(2, 1, null, ulong.MaxValue, [1, 2, 3, 4, 5, 6]),
        new TapeGrab(2, 1, "covered", 0, null),
        new TapeEnd("the script ended"),
    ];

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public void Entries_come_back_as_they_were_written()
    {
        TapeEntry[] read = [.. Read(Written(Encoded(Every)))];

        Assert.Equal(Every.Select(Text), read.Select(Text));
    }

    [Fact]
    public void Tape_cut_off_anywhere_is_read_up_to_the_last_whole_chunk()
    {
        const int entriesOfAChunk = 5;
        byte[] first = Encoded(Every[..entriesOfAChunk]);
        byte[] tape = Written(first, first, first);
        int wholeBefore = 0;
        for (int length = 8; length < tape.Length; length++)
        {
            var reader = new TapeReader(new MemoryStream(tape, 0, length));
            int entries = reader.Entries().Count();

            Assert.True(reader.IsInterrupted);
            Assert.Equal(0, entries % entriesOfAChunk);
            Assert.InRange(entries, wholeBefore, 2 * entriesOfAChunk);
            wholeBefore = entries;
        }

        Assert.Equal(2 * entriesOfAChunk, wholeBefore);
    }

    [Fact]
    public void Tape_with_its_end_is_not_interrupted()
    {
        var reader = new TapeReader(new MemoryStream(Written(Encoded(Every))));

        Assert.IsType<TapeEnd>(reader.Entries().Last());
        Assert.False(reader.IsInterrupted);
    }

    /// <summary>The checksum is right here: what is damaged are the entries.</summary>
    [Fact]
    public void Damaged_entries_are_read_or_refused()
    {
        byte[] healthy = Encoded(Every);
        byte[] values = [0, 1, 2, 5, 7, 8, 9, 10, 11, 127, 128, 255];
        int refused = 0;
        RandomCases.Check(
            20_000,
            ByteChange.Lists(4, 8, values),
            changes =>
            {
                try
                {
                    Assert.InRange(new TapeDecoder().EntriesOf(ByteChange.Apply(changes, healthy)).Count(), 0, 2 * healthy.Length);
                }
                catch (InvalidDataException e)
                {
                    Assert.StartsWith("it is damaged", e.Message, StringComparison.Ordinal);
                    refused++;
                }
            }
        );
        Assert.InRange(refused, 5_000, 20_000);
    }

    [Fact]
    public void Changed_byte_of_a_file_changes_no_entry_unnoticed()
    {
        byte[] tape = Written(Encoded(Every));
        string[] healthy = [.. Read(tape).Select(Text)];
        for (int at = 0; at < tape.Length; at++)
        {
            byte[] damaged = [.. tape];
            damaged[at] ^= 0x20;
            var reader = new TapeReader(new MemoryStream(damaged));
            string[] read = [];
            string? message = Record.Exception(() => read = [.. reader.Entries().Select(Text)])?.Message;

            // A longer chunk looks like a tape that was cut off. The last byte of packed data has bits without a meaning.
            Assert.True(
                message?.StartsWith("it ", StringComparison.Ordinal) == true || reader.IsInterrupted || read.SequenceEqual(healthy),
                $"Byte {at}: {message}"
            );
        }
    }

    [Theory]
    [InlineData(TapeFormat.MaxChunkBytes + 1u, 1u)]
    [InlineData(1u, TapeFormat.MaxChunkBytes + 1u)]
    [InlineData(uint.MaxValue, uint.MaxValue)]
    public void Chunk_above_the_limit_is_refused_before_memory_is_taken(uint packed, uint length)
    {
        byte[] tape =
        [
            .. TapeFormat.Magic,
            TapeFormat.Version,
            .. BitConverter.GetBytes(packed),
            .. BitConverter.GetBytes(length),
            .. new byte[4],
        ];

        Assert.Throws<InvalidDataException>(() => Read(tape).Count());
    }

    /// <summary>A value takes a byte on the tape and more in memory.</summary>
    [Fact]
    public void List_of_very_many_values_is_refused()
    {
        byte[] call = [(byte)TapeTag.Call, 0, .. new byte[8], 0x81, 0x80, 0x04, .. new byte[70_000]];

        Assert.Contains(
            "a list that is too long",
            Assert.Throws<InvalidDataException>(() => Read(Written(call)).Count()).Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Chunk_that_unpacks_to_more_than_it_says_is_refused()
    {
        byte[] tape = Written(new byte[1000]);
        BitConverter.GetBytes(10).CopyTo(tape, 12);

        Assert.Contains("checksum", Assert.Throws<InvalidDataException>(() => Read(tape).Count()).Message, StringComparison.Ordinal);
    }

    private static IEnumerable<TapeEntry> Read(byte[] tape) => new TapeReader(new MemoryStream(tape)).Entries();

    private static byte[] Encoded(IEnumerable<TapeEntry> entries)
    {
        var encoder = new TapeEncoder();
        foreach (TapeEntry entry in entries)
        {
            encoder.Add(entry);
        }

        return encoder.Take();
    }

    private byte[] Written(params byte[][] chunks)
    {
        string path = Path.Combine(_folder.FullName, Guid.NewGuid() + TapeFormat.Extension);
        using (var file = new TapeFile(path))
        {
            Array.ForEach(chunks, chunk => file.Append(chunk));
        }

        return File.ReadAllBytes(path);
    }

    /// <summary>An entry with all its lists as text: lists of records are compared by reference.</summary>
    private static string Text(TapeEntry entry) =>
        entry switch
        {
            TapeCall call => $"{call.Target} {string.Join(';', call.Asked)} {call.Answer} "
                + string.Join(';', call.Written.Select(slots => string.Join(',', slots))),
            TapeGrab grab => $"{grab with { Pixels = null }} {string.Join(',', grab.Pixels ?? [])}",
            _ => entry.ToString(),
        };
}
