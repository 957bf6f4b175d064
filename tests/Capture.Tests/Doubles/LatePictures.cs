using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Doubles;

/// <summary>The screen of a fake game whose pictures are drawn when the test says so.</summary>
internal sealed class LatePictures(FakeGame game) : IDeferringScreen
{
    private readonly Queue<(PixelBuffer Shown, PixelBuffer Target, TaskCompletionSource Drawing)> _undrawn = new();

    /// <summary>Number of pictures that are not drawn.</summary>
    public int Undrawn => _undrawn.Count;

    public GrabResult Grab(PixelBuffer target) => game.Grab(target);

    public Task GrabLater(PixelBuffer target)
    {
        var shown = new PixelBuffer(target.Size);
        game.Grab(shown);
        var drawing = new TaskCompletionSource();
        _undrawn.Enqueue((shown, target, drawing));
        return drawing.Task;
    }

    public void DrawOldest()
    {
        (PixelBuffer shown, PixelBuffer target, TaskCompletionSource drawing) = _undrawn.Dequeue();
        shown.Bytes.CopyTo(target.Bytes, 0);
        drawing.SetResult();
    }

    public void FailOldest(string message) => _undrawn.Dequeue().Drawing.SetException(new InvalidOperationException(message));
}
