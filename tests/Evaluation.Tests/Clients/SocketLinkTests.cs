using Harvester.Evaluation.Clients;

namespace Harvester.Evaluation.Tests.Clients;

public sealed class SocketLinkTests
{
    private static readonly TimeSpan Ample = TimeSpan.FromSeconds(30);

    [Fact]
    public void Receive_gives_a_frame()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, "open sesame", Ample);
        game.Say(FakeGame.Frame(7, 12));
        ClientFrame frame = link.Receive(Ample)!;

        Assert.Equal((7, 0.7, 5, 12), (frame.Frame, frame.TimeSeconds, frame.State.SpeedMetresPerSecond, frame.Position!.Value.X));
        Assert.Equal(-2.7, frame.State.Indicators.ToMarkingML.Value, 6);
        Assert.Equal((-0.05, 0), (frame.State.Indicators.Angle.Value, frame.State.TorcsEquivalent.Angle.Value));
        Assert.Equal("""{"type":"hello","token":"open sesame"}""", game.Hear());
        Assert.Equal("""{"type":"requestFrame"}""", game.Hear());
    }

    [Fact]
    public void Receive_gives_the_newest_of_the_frames_that_have_come()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        game.Say([.. FakeGame.Frame(1), .. FakeGame.Frame(2), .. FakeGame.Frame(3)]);

        Assert.Equal(3, link.Receive(Ample)!.Frame);
        Assert.Null(link.Receive(TimeSpan.FromMilliseconds(1)));
    }

    [Fact]
    public void Receive_gives_the_newest_frame_and_then_the_end()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        game.Hear();
        game.Say([.. FakeGame.Frame(1), .. FakeGame.Frame(2)]);
        game.Close();

        Assert.Equal(2, link.Receive(Ample)!.Frame);
        Assert.Equal("The game has closed the bridge.", Assert.ThrowsAny<IOException>(() => link.Receive(Ample)).Message);
    }

    [Fact]
    public void Receive_of_nothing_is_null()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);

        Assert.Null(link.Receive(TimeSpan.FromMilliseconds(1)));
    }

    [Fact]
    public void Receive_of_an_error_reports_its_reason() => AssertFails(
        FakeGame.Message("""{"type":"error","reason":"the first message must be a hello with the right token."}"""),
        "a hello with the right token");

    [Theory]
    [InlineData("nonsense")]
    [InlineData("[1]")]
    [InlineData("""{"type":"frame"}""")]
    [InlineData("""{"type":"frame","frame":1,"timeSeconds":0,"speedMetresPerSecond":5,"position":[0],"headingDegrees":0,"fast":true"""
        + ""","indicators":[1],"torcsEquivalent":[1]}""")]
    public void Receive_of_something_else_than_a_frame_fails(string header) => AssertFails(FakeGame.Message(header), "an invalid frame");

    [Fact]
    public void Receive_of_an_impossible_length_reports_it() => AssertFails([0x7f, 0, 0, 0, 0, 0, 0, 0], "a message of 2130706432 bytes");

    [Fact]
    public void Receive_of_a_message_that_is_not_ended_gives_up()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, TimeSpan.FromSeconds(3));
        game.Say(FakeGame.Frame(1)[..20]);

        Assert.Contains(
            "in the middle of a message", Assert.Throws<IOException>(() => link.Receive(Ample)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Receive_of_a_truncated_message_fails()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        game.Hear();
        game.Say(FakeGame.Frame(1)[..20]);
        game.Close();

        Assert.Contains(
            "in the middle of a message", Assert.Throws<IOException>(() => link.Receive(Ample)).Message, StringComparison.Ordinal);
    }

    private static void AssertFails(byte[] message, string words)
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        game.Say(message);

        Assert.Contains(words, Assert.Throws<IOException>(() => link.Receive(Ample)).Message, StringComparison.Ordinal);
    }
}
