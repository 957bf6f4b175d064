using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Harvesting;

/// <summary>A harvest whose pictures are drawn while the next frames are taken.</summary>
public sealed class DeferredPictureTests : IDisposable
{
    private const int MaxUndrawn = 2;
    private const int Frames = 12;

    private static readonly HarvestOptions Small = new()
    {
        Image = new ImageSize(64, 48),
        MaxFrames = Frames,
        OcclusionSamples = 4,
        ProbeLag = false,
    };

    private readonly FakeGame _game = new();
    private readonly MemorySink _sink = new();
    private readonly LatePictures _screen;

    public DeferredPictureTests() => _screen = new LatePictures(_game);

    public void Dispose() => _sink.Dispose();

    [Fact]
    public void Frames_are_taken_while_pictures_are_undrawn()
    {
        using HarvestSession session = Session(Small);
        int most = 0;
        while (!session.Status.IsOver)
        {
            Step(session);
            most = Math.Max(most, session.Counters.Taken - session.Counters.Captured);
        }

        Assert.Equal(MaxUndrawn, most);
        Assert.Null(session.Fault);
    }

    [Fact]
    public void Frames_keep_their_order_and_their_pictures()
    {
        using HarvestSession session = Session(Small);
        Run(session);

        Assert.Equal(Enumerable.Range(0, Frames), _sink.Frames.Select(frame => frame.Label.Frame));
        Assert.All(_sink.Frames, frame => Assert.Equal(FakeGame.StateAt(frame.Label.TimeSeconds), FakeGame.StateOf(frame.Picture)));
    }

    [Fact]
    public void Frames_are_those_of_a_screen_that_does_not_defer()
    {
        using HarvestSession session = Session(Small);
        Run(session);
        var other = new FakeGame();
        var otherSink = new MemorySink();
        using var prompt = new HarvestSession(Small, other.Ports, otherSink);
        other.Run(prompt);

        Assert.Equal(otherSink.Frames.Select(Line), _sink.Frames.Select(Line));
        Assert.Equal(
            (otherSink.End!.GameFrame, otherSink.End.TimeSeconds, otherSink.End.Captured),
            (_sink.End!.GameFrame, _sink.End.TimeSeconds, _sink.End.Captured)
        );
    }

    [Fact]
    public void Numbers_of_a_shard_count_the_frames_of_others()
    {
        using HarvestSession session = Session(Small with { Shard = new Shard(2, 3) });
        Run(session);

        Assert.Equal([1, 4, 7, 10], _sink.Frames.Select(frame => frame.Label.Frame));
    }

    [Fact]
    public void Failure_of_drawing_ends_the_harvest_before_its_frame()
    {
        using HarvestSession session = Session(Small);
        while (_sink.Frames.Count < 3)
        {
            Step(session);
        }

        _screen.FailOldest("Out of paint.");
        Run(session);

        Assert.Equal("The harvest stopped: Out of paint.", session.Fault);
        Assert.Equal(session.Fault, _sink.End!.Fault);
        Assert.Equal([0, 1, 2], _sink.Frames.Select(frame => frame.Label.Frame));
        Assert.False(_game.WantsFrozen);
    }

    [Fact]
    public void Stop_hands_over_the_frames_still_queued()
    {
        using HarvestSession session = Session(Small);
        StepUntilUndrawn(session);
        _screen.DrawOldest();
        _screen.DrawOldest();
        session.Stop();

        Assert.Equal([0, 1], _sink.Frames.Select(frame => frame.Label.Frame));
        Assert.Equal(2, _sink.End!.Captured);
    }

    [Fact]
    public void Stop_reports_a_failure_of_drawing()
    {
        using HarvestSession session = Session(Small);
        StepUntilUndrawn(session);
        _screen.FailOldest("Out of paint.");
        _screen.DrawOldest();
        session.Stop();

        Assert.Equal("The harvest stopped: Out of paint.", session.Fault);
        Assert.Empty(_sink.Frames);
    }

    [Fact]
    public void Stop_drops_frames_when_the_sink_is_full()
    {
        using HarvestSession session = Session(Small);
        StepUntilUndrawn(session);
        _screen.DrawOldest();
        _screen.DrawOldest();
        _sink.HasRoom = false;
        session.Stop();

        Assert.Null(session.Fault);
        Assert.Empty(_sink.Frames);
        Assert.Equal(0, _sink.End!.Captured);
    }

    [Fact]
    public void Unwanted_picture_keeps_its_buffer_until_it_is_drawn()
    {
        var pool = new PixelBufferPool(Small.Image);
        PixelBuffer first = pool.Rent();
        pool.Return(first);
        var picture = new GrabbedPicture(_screen, pool);

        picture.Dispose();
        PixelBuffer other = pool.Rent();
        _screen.DrawOldest();

        Assert.NotSame(first, other);
        Assert.Same(first, pool.Rent());
    }

    private static string Line(CapturedFrame frame) => JsonLabelWriter.Line(frame.Label) + FakeGame.StateOf(frame.Picture);

    private HarvestSession Session(HarvestOptions options) => new(options, _game.Ports with { Screen = _screen }, _sink);

    private void Run(HarvestSession session)
    {
        while (!session.Status.IsOver)
        {
            Step(session);
        }
    }

    /// <summary>Draws no picture before the harvest must wait for it.</summary>
    private void Step(HarvestSession session)
    {
        bool isLast = session.Counters.Taken == Frames;
        if (_screen.Undrawn > 0 && (isLast || _screen.Undrawn == MaxUndrawn))
        {
            _screen.DrawOldest();
        }

        session.Step();
        _game.Tick();
    }

    private void StepUntilUndrawn(HarvestSession session)
    {
        while (session.Counters.Taken < MaxUndrawn)
        {
            session.Step();
            _game.Tick();
        }
    }
}
