using Harvester.Play.Tapes;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Tapes;

/// <summary>Chunks come back as they were, however far back they repeat something, and damage is refused.</summary>
public sealed class RepeatPackerTests
{
    private const int ChunkBytes = 1 << 20;

    [Fact]
    public void Chunk_that_was_packed_before_takes_a_few_bytes()
    {
        byte[] chunk = Random(1, ChunkBytes);
        (byte[][] packed, byte[][] unpacked) = PackAndUnpack([chunk, chunk, [.. chunk.Skip(1000), .. chunk.Take(1000)]]);

        AssertSame([chunk, chunk, [.. chunk.Skip(1000), .. chunk.Take(1000)]], unpacked);
        Assert.InRange(packed[0].Length, ChunkBytes, ChunkBytes + 8);
        Assert.InRange(packed[1].Length, 1, 16);
        Assert.InRange(packed[2].Length, 1, 32);
    }

    /// <summary>More than the window holds: it moves on several times.</summary>
    [Fact]
    [Trait("Category", "Heavy")]
    public void Repetition_is_found_within_the_reach_only()
    {
        byte[] first = Random(2, ChunkBytes);
        byte[][] others = [.. Enumerable.Range(3, 6).Select(seed => Random(seed, ChunkBytes))];
        byte[][] chunks = [first, .. others, first, .. others, .. Enumerable.Range(10, 20).Select(seed => Random(seed, ChunkBytes)), first];
        (byte[][] packed, byte[][] unpacked) = PackAndUnpack(chunks);

        AssertSame(chunks, unpacked);
        Assert.All(packed[7..14], chunk => Assert.InRange(chunk.Length, 1, 16));
        Assert.InRange(packed[^1].Length, ChunkBytes, ChunkBytes + 8);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Chunk_larger_than_the_window_comes_back()
    {
        byte[][] chunks = [Random(1, 1000), [.. Random(2, TapeFormat.MaxChunkBytes - 1000), .. Random(1, 1000)], [], [7]];

        AssertSame(chunks, PackAndUnpack(chunks).Unpacked);
    }

    [Fact]
    public void Random_chunks_come_back()
    {
        var random = new Random(11);
        byte[][] chunks =
        [
            .. Enumerable
                .Range(0, 2000)
                .Select(i =>
                {
                    byte[] piece = Random(i % 3, random.Next(60));
                    return (byte[])[.. Enumerable.Repeat(piece, random.Next(6)).SelectMany(each => each), .. Random(i, random.Next(40))];
                }),
        ];

        AssertSame(chunks, PackAndUnpack(chunks).Unpacked);
    }

    [Fact]
    public void Damaged_chunk_is_read_or_refused()
    {
        byte[] piece = Random(1, 100);
        byte[] chunk = [.. piece, .. Random(2, 30), .. piece, .. new byte[100], .. piece];
        byte[] packed = PackAndUnpack([chunk]).Packed[0];
        byte[] values = [0, 1, 24, 99, 100, 127, 128, 255];
        int refused = 0;
        RandomCases.Check(
            20_000,
            ByteChange.Lists(4, 8, values),
            changes =>
            {
                try
                {
                    byte[] read = new RepeatUnpacker().Unpack(new MemoryStream(ByteChange.Apply(changes, packed)), chunk.Length);
                    Assert.Equal(chunk.Length, read.Length);
                }
                catch (InvalidDataException)
                {
                    refused++;
                }
            }
        );
        Assert.InRange(refused, 1_000, 20_000);
    }

    private static void AssertSame(byte[][] expected, byte[][] actual)
    {
        Assert.Equal(expected.Length, actual.Length);
        Assert.All(expected.Zip(actual), pair => Assert.True(pair.First.AsSpan().SequenceEqual(pair.Second)));
    }

    private static (byte[][] Packed, byte[][] Unpacked) PackAndUnpack(byte[][] chunks)
    {
        var packer = new RepeatPacker();
        var unpacker = new RepeatUnpacker();
        byte[][] packed =
        [
            .. chunks.Select(chunk =>
            {
                using var target = new MemoryStream();
                packer.Pack(chunk, target);
                return target.ToArray();
            }),
        ];
        return (
            packed,
            [
                .. packed.Zip(
                    chunks,
                    (each, chunk) =>
                    {
                        using var source = new MemoryStream(each);
                        byte[] unpacked = unpacker.Unpack(source, chunk.Length);
                        Assert.Equal(source.Length, source.Position);
                        return unpacked;
                    }
                ),
            ]
        );
    }

    private static byte[] Random(int seed, int length)
    {
        byte[] bytes = new byte[length];
        new Random(seed).NextBytes(bytes);
        return bytes;
    }
}
