using Harvester.Sessions.Lidar;
using Harvester.Sessions.Semantics;

namespace Harvester.Sessions.Tests.Lidar;

public sealed class LidarFileTests
{
    private static readonly LidarPoint Point = new(1.5f, -2.25f, 0.125f, 0.5f, 300, 31, 40_000, SemanticClass.Car);

    [Fact]
    public void Point_has_the_documented_bytes()
    {
        // 1.5 is 0x3FC00000, -2.25 is 0xC0100000, 0.125 is 0x3E000000, 0.5 is 0x3F000000; 300 is 0x012C, 40,000 is 0x9C40; a car is 11.
        Assert.Equal("0000C03F000010C00000003E0000003F2C011F00409C0B00", Convert.ToHexString(BytesOf(Point)));
    }

    [Fact]
    public void Points_are_read_back() =>
        Assert.Equal([Point, Point with { IsInterpolated = true }], LidarFile.Read(BytesOf(Point, Point with { IsInterpolated = true })));

    [Theory]
    [InlineData(22, 22, "point 0 has an unknown class.")]
    [InlineData(23, 2, "point 0 has unknown flags.")]
    [InlineData(3, 0x7F, "point 0 has no finite position.")]
    [InlineData(15, 0x40, "point 0 has an intensity outside 0 to 1.")]
    public void Damaged_point_is_refused(int at, byte value, string message)
    {
        byte[] bytes = BytesOf(Point);
        (bytes[at], bytes[2]) = (value, at == 3 ? (byte)0x80 : bytes[2]);

        Assert.Equal(message, Assert.Throws<FormatException>(() => LidarFile.Read(bytes)).Message);
    }

    [Fact]
    public void Part_of_a_point_is_refused() =>
        Assert.StartsWith(
            "it has 23 bytes",
            Assert.Throws<FormatException>(() => LidarFile.Read(new byte[23])).Message,
            StringComparison.Ordinal
        );

    private static byte[] BytesOf(params LidarPoint[] points)
    {
        using var stream = new MemoryStream();
        LidarFile.Write(stream, points);
        return stream.ToArray();
    }
}
