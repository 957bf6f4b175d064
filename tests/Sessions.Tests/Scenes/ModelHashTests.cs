using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Tests.Scenes;

public sealed class ModelHashTests
{
    // Published pairs of names and hashes of the game.
    [Theory]
    [InlineData("prop_sign_road_01a", -949234773)]
    [InlineData("PROP_SIGN_ROAD_01A", -949234773)]
    [InlineData("prop_sign_road_01b", 2029303486)]
    [InlineData("prop_traffic_01a", 1043035044)]
    [InlineData("asea", -1809822327)]
    [InlineData("", 0)]
    public void Of_name_is_the_games_hash(string model, int hash) => Assert.Equal(hash, ModelHash.Of(model));

    [Theory]
    [InlineData("-949234773")]
    [InlineData("3345732523")]
    [InlineData("0xC76BD3AB")]
    public void TryParse_reads_signed_unsigned_and_hexadecimal(string text)
    {
        Assert.True(ModelHash.TryParse(text, out int hash));
        Assert.Equal(-949234773, hash);
    }

    [Theory]
    [InlineData("")]
    [InlineData("0x")]
    [InlineData("4294967296")]
    [InlineData("-2147483649")]
    [InlineData("1.5")]
    [InlineData("stop")]
    public void TryParse_rejects_anything_but_a_32_bit_number(string text) => Assert.False(ModelHash.TryParse(text, out _));
}
