using Harvester.Capture.Harvesting;

namespace Harvester.Driving.Recording;

/// <summary>
/// Holds back the newest frame of a harvest until the next one comes or the harvest ends: only then is known what the car did after it.
/// </summary>
/// <param name="sink">Receives the frames.</param>
/// <param name="complete">Completes the label of a frame that is handed on; called once for each.</param>
internal sealed class HeldSink(IFrameSink sink, Action<CapturedFrame> complete) : IFrameSink
{
    private CapturedFrame? _held;
    private bool _isComplete;

    public string? Fault => sink.Fault;

    public int FirstFrame => sink.FirstFrame;

    public int FirstObjectId => sink.FirstObjectId;

    public int FirstEventId => sink.FirstEventId;

    /// <summary>Number of frames received.</summary>
    public int Received { get; private set; }

    public void Open(SessionStart start) => sink.Open(start);

    public bool TryEnqueue(CapturedFrame frame)
    {
        if (!TryHandOn())
        {
            return false;
        }

        _held = frame;
        _isComplete = false;
        Received++;
        return true;
    }

    public void Close(SessionEnd end)
    {
        TryHandOn();
        sink.Close(end);
    }

    public void Dispose()
    {
        _held?.Dispose();
        _held = null;
        sink.Dispose();
    }

    private bool TryHandOn()
    {
        if (_held is not { } frame)
        {
            return true;
        }

        if (!_isComplete)
        {
            complete(frame);
            _isComplete = true;
        }

        if (!sink.TryEnqueue(frame))
        {
            return false;
        }

        _held = null;
        return true;
    }
}
