using Harvester.Play.Tapes;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Tapes;

/// <summary>A recording has a bound, and says when it is reached.</summary>
public sealed class TapeRecorderTests : IDisposable
{
    /// <summary>A chunk before compression: what a file may exceed its bound by.</summary>
    private const int ChunkBytes = 256 * 1024;

    private readonly string _folder = Directory.CreateTempSubdirectory("recorder").FullName;
    private readonly List<string> _told = [];
    private readonly TestClock _clock = new();

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Recording_ends_at_its_largest_file()
    {
        const int bound = 1_000_000;
        TapeEntry[] entries = RecordUntilItEnds(Options with { MaxFileBytes = bound }, out long length);

        Assert.InRange(length, bound, bound + (2 * ChunkBytes));
        Assert.IsType<TapeEnd>(entries[^1]);
        Assert.Contains("The recording ended because the tape is full: tape-", Assert.Single(_told), StringComparison.Ordinal);
    }

    [Fact]
    public void Recording_ends_before_a_reader_refuses_its_size()
    {
        const int bound = 1_000_000;
        TapeEntry[] entries = RecordUntilItEnds(Options with { MaxUnpackedBytes = bound }, out long length);

        Assert.InRange(length, 1, bound + (2 * ChunkBytes));
        Assert.IsType<TapeEnd>(entries[^1]);
        Assert.Contains("the tape is full", Assert.Single(_told), StringComparison.Ordinal);
        Assert.InRange(new TapeOptions(TapeChoice.Natives, 1, _folder).MaxUnpackedBytes, 1, TapeFormat.MaxUnpackedBytes / 2);
    }

    [Fact]
    public void Nothing_follows_a_chunk_that_the_disk_refused_a_part_of()
    {
        var disk = new FillingStream();
        byte[] chunk = Chunk();
        using (var file = new TapeFile(() => disk))
        {
            file.Append(chunk);
            disk.Free = 5;
            Assert.Throws<IOException>(() => file.Append(chunk));
            disk.Free = long.MaxValue;
            Assert.Equal(0, file.Append(chunk));
        }

        var reader = new TapeReader(new MemoryStream(disk.ToArray()));
        Assert.Single(reader.Entries());
        Assert.True(reader.IsInterrupted);
    }

    private TapeOptions Options => new(TapeChoice.Natives, 10, Path.Combine(_folder, "out"));

    private static byte[] Chunk()
    {
        var encoder = new TapeEncoder();
        encoder.Add(new TapeKey(73, false));
        return encoder.Take();
    }

    /// <summary>Records calls that compress badly until the recording ends by itself, and reads what it wrote.</summary>
    private TapeEntry[] RecordUntilItEnds(TapeOptions options, out long length)
    {
        const int callsOfATick = 1000;
        const int maxTicks = 10_000;
        var random = new Random(7);
        using (var recorder = new TapeRecorder(options, _clock, _told.Add))
        {
            for (int tick = 0; recorder.IsOn && tick < maxTicks; tick++)
            {
                recorder.BeginEvent(null);
                for (int i = 0; i < callsOfATick; i++)
                {
                    recorder.Call(new TapeCall(1, [TapeValue.Of(random.Next())], TapeValue.Of(random.NextSingle()), []));
                }

                SpinWait.SpinUntil(() => !recorder.IsBusy);
                recorder.EndEvent();
            }

            Assert.False(recorder.IsOn);
            SpinWait.SpinUntil(() => !recorder.IsBusy);
        }

        byte[] tape = File.ReadAllBytes(Assert.Single(Directory.GetFiles(options.Folder)));
        length = tape.Length;
        return [.. new TapeReader(new MemoryStream(tape)).Entries()];
    }
}
