using Harvester.Exports.Formats.MotionScenarios;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Tests.MotionScenarios;

/// <summary>Frames of TFRecord.</summary>
public sealed class TfRecordTests
{
    /// <summary>The check value of CRC-32C, that of the digits 1 to 9, is 0xE3069283 (RFC 3720 has the polynomial); TFRecord rotates it
    /// right by 15 bits and adds 0xA282EAD8; here little-endian.</summary>
    private const string CheckValue = "e5b08ac7";

    [Fact]
    public void Checksum_is_the_masked_check_value()
    {
        using var stream = new MemoryStream();
        TfRecord.Write(stream, "123456789"u8);

        Assert.Equal(CheckValue, Convert.ToHexStringLower(stream.ToArray()[^4..]));
    }

    [Fact]
    public void Records_are_read_as_they_were_written()
    {
        using var stream = new MemoryStream();
        TfRecord.Write(stream, "one"u8);
        TfRecord.Write(stream, []);
        stream.Position = 0;

        byte[][] expected = ["one"u8.ToArray(), []];
        Assert.Equal(expected, TfRecord.Read(stream).ToArray());
    }

    [Theory]
    [InlineData(0, "record 0 in it is damaged, or it is no TFRecord file without compression.")]
    [InlineData(8, "record 0 in it is damaged, or it is no TFRecord file without compression.")]
    [InlineData(12, "record 0 in it is cut off or damaged.")]
    [InlineData(15, "record 0 in it is cut off or damaged.")]
    public void Damage_anywhere_is_found(int place, string expected)
    {
        using var stream = new MemoryStream();
        TfRecord.Write(stream, "one"u8);
        byte[] damaged = stream.ToArray();
        damaged[place] ^= 1;

        Assert.Equal(expected, Assert.Throws<DatasetFormatException>(() => TfRecord.Read(new MemoryStream(damaged)).ToList()).Message);
    }
}
