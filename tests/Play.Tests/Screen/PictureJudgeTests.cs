using Harvester.Geometry.Cameras;
using Harvester.Play.Screen;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Tests.Screen;

public sealed class PictureJudgeTests
{
    [Theory]
    [InlineData(0, 0, 0, GrabRefusals.Black)]
    [InlineData(16, 16, 16, GrabRefusals.Black)]
    [InlineData(17, 16, 16, GrabRefusals.SingleColour)]
    [InlineData(255, 255, 255, GrabRefusals.SingleColour)]
    public void RefusalOf_one_colour_names_it(byte red, byte green, byte blue, string refusal) =>
        Assert.Equal(refusal, PictureJudge.RefusalOf(Uniform(red, green, blue)));

    [Theory]
    [InlineData(0)]
    [InlineData(4)]
    [InlineData(35)]
    public void RefusalOf_a_black_picture_with_one_lit_byte_is_null(int index)
    {
        PixelBuffer night = Uniform(0, 0, 0);
        night.Bytes[index] = 1;

        Assert.Null(PictureJudge.RefusalOf(night));
    }

    private static PixelBuffer Uniform(byte red, byte green, byte blue)
    {
        var buffer = new PixelBuffer(new ImageSize(4, 3));
        for (int i = 0; i < buffer.Bytes.Length; i += PixelBuffer.BytesPerPixel)
        {
            buffer.Bytes[i] = red;
            buffer.Bytes[i + 1] = green;
            buffer.Bytes[i + 2] = blue;
        }

        return buffer;
    }
}
