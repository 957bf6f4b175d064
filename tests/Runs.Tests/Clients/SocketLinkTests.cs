using Harvester.Runs.Clients;

namespace Harvester.Runs.Tests.Clients;

public sealed class SocketLinkTests
{
    private static readonly TimeSpan Ample = TimeSpan.FromSeconds(30);

    [Fact]
    public void Receive_gives_a_frame()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, "open sesame", Ample);
        game.Say(FakeGame.Frame(7, 12));
        ClientFrame frame = Next(link);

        Assert.Equal((7, 0.7, 5, 12), (frame.Frame, frame.TimeSeconds, frame.State.SpeedMetresPerSecond, frame.Position!.Value.X));
        Assert.Equal(-2.7, frame.State.Indicators.ToMarkingML.Value, 6);
        Assert.Equal((-0.05, 0), (frame.State.Indicators.Angle.Value, frame.State.TorcsEquivalent.Angle.Value));
        Assert.Equal("""{"type":"hello","version":1,"token":"open sesame"}""", game.Receive());
        Assert.Equal("""{"type":"requestFrame"}""", game.Receive());
    }

    [Fact]
    public void Receive_gives_the_newest_of_the_frames_that_have_come()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        game.Say([.. FakeGame.Frame(1), .. FakeGame.Frame(2), .. FakeGame.Frame(3)]);

        Assert.Equal(3, Next(link).Frame);
        Assert.Null(link.Receive(TimeSpan.FromMilliseconds(1)));
    }

    [Fact]
    public void Receive_gives_the_newest_frame_and_then_the_end()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        game.Receive();
        game.Receive();
        game.Say([.. FakeGame.Frame(1), .. FakeGame.Frame(2)]);
        game.Close();

        Assert.Equal(2, Next(link).Frame);
        Assert.Equal("The game has closed the bridge.", Assert.ThrowsAny<IOException>(() => Next(link)).Message);
    }

    [Fact]
    public void Receive_of_nothing_is_null()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);

        Assert.Null(link.Receive(TimeSpan.FromMilliseconds(1)));
    }

    [Fact]
    public void Receive_of_an_error_reports_its_reason() =>
        AssertFails(
            FakeGame.Message("""{"type":"error","reason":"the first message must be a hello with the right token."}"""),
            "a hello with the right token"
        );

    [Theory]
    [InlineData("nonsense")]
    [InlineData("[1]")]
    [InlineData("""{"type":"frame"}""")]
    [InlineData(
        """{"type":"frame","frame":1,"timeSeconds":0,"speedMetresPerSecond":5,"position":[0],"headingDegrees":0,"fast":true"""
            + ""","indicators":[1],"torcsEquivalent":[1]}"""
    )]
    public void Receive_of_anything_but_a_frame_fails(string header) => AssertFails(FakeGame.Message(header), "an invalid frame");

    [Fact]
    public void Receive_of_an_impossible_length_reports_it() => AssertFails([0x7f, 0, 0, 0, 0, 0, 0, 0], "a message of 2130706432 bytes");

    [Fact]
    [Trait("Category", "Heavy")]
    public void Receive_of_an_incomplete_message_gives_up()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, TimeSpan.FromSeconds(3));
        game.Say(FakeGame.Frame(1)[..20]);

        Assert.Contains("in the middle of a message", Assert.Throws<IOException>(() => Next(link)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Receive_of_a_truncated_message_fails()
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        game.Receive();
        game.Receive();
        game.Say(FakeGame.Frame(1)[..20]);
        game.Close();

        Assert.Contains("in the middle of a message", Assert.Throws<IOException>(() => Next(link)).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("""{"type":"hello","version":2}""", "the game speaks version 2 of the bridge, this program version 1")]
    [InlineData("""{"type":"hello"}""", "field version must be a number")]
    [InlineData("""{"type":"frame"}""", "the first message of the game must be a hello")]
    [InlineData("""{"type":"error","reason":"no."}""", "The game has closed the bridge: no.")]
    public void Game_of_another_version_is_refused(string hello, string words)
    {
        using FakeGame game = new() { Hello = hello };
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        Assert.Equal("""{"type":"hello","version":1}""", game.Receive());

        Assert.Contains(words, Assert.Throws<IOException>(() => Next(link)).Message, StringComparison.Ordinal);
    }

    /// <summary>The next frame. A call of Receive may return with the game's hello alone.</summary>
    private static ClientFrame Next(SocketLink link) => (link.Receive(Ample) ?? link.Receive(Ample))!;

    private static void AssertFails(byte[] message, string words)
    {
        using FakeGame game = new();
        using SocketLink link = new("127.0.0.1", game.Port, null, Ample);
        game.Say(message);

        Assert.Contains(words, Assert.Throws<IOException>(() => Next(link)).Message, StringComparison.Ordinal);
    }
}
