using Harvester.Driving.Bridge;

namespace Harvester.Driving.Tests.Bridge;

public sealed class RestartMessageTests
{
    [Theory]
    [InlineData("""{"type":"restart","seed":7}""", 7, null, true)]
    [InlineData("""{"type":"restart","seed":0,"town":12,"image":false}""", 0, 12, false)]
    public void Restart_has_a_seed_and_may_have_a_town(string header, int seed, int? town, bool hasPicture) =>
        Assert.Equal(new RestartMessage(seed, town, hasPicture), ClientMessageParser.Parse(header));

    [Theory]
    [InlineData("""{"type":"restart"}""", "seed must be a number")]
    [InlineData("""{"type":"restart","seed":1.5}""", "seed must be a whole number")]
    [InlineData("""{"type":"restart","seed":-1}""", "seed must be a whole number")]
    [InlineData("""{"type":"restart","seed":1,"town":2147483648}""", "town must be a whole number")]
    [InlineData("""{"type":"step","seconds":0.1,"image":1}""", "image must be true or false")]
    public void Invalid_field_is_named(string header, string reason)
    {
        BridgeException exception = Assert.Throws<BridgeException>(() => ClientMessageParser.Parse(header));

        Assert.Contains(reason, exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Steps_and_requests_may_do_without_an_image()
    {
        Assert.Equal(new StepMessage(0.1, HasPicture: false), ClientMessageParser.Parse("""{"type":"step","seconds":0.1,"image":false}"""));
        Assert.Equal(new RequestFrameMessage(HasPicture: false), ClientMessageParser.Parse("""{"type":"requestFrame","image":false}"""));
    }
}
