using Harvester.Driving.Bridge;
using Harvester.Geometry.Cameras;

namespace Harvester.Driving.Session;

/// <summary>How a car is driven over a bridge.</summary>
public sealed record DrivingOptions
{
    private readonly double _rateHz = 10;
    private readonly double _patienceSeconds = SilenceWatch.DefaultPatienceSeconds;
    private readonly int _settleTicks = 4;

    /// <summary>Frames per second of the game's time; greater than 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not greater than 0, or not finite.</exception>
    public double RateHz
    {
        get => _rateHz;
        init => _rateHz = Positive(value, nameof(RateHz));
    }

    /// <summary>Size of the images, pixels; by default DeepDriving's. The bridge must use the same.</summary>
    public ImageSize Picture { get; init; } = new(280, 210);

    /// <summary>How long controls hold, seconds of the game's time; greater than 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not greater than 0, or not finite.</exception>
    public double PatienceSeconds
    {
        get => _patienceSeconds;
        init => _patienceSeconds = Positive(value, nameof(PatienceSeconds));
    }

    /// <summary>
    /// Maximum number of ticks by which the picture may lag, 0 or more. A paused world must have stood still that long before its frame is
    /// sent, and nothing that does not belong in an image may be drawn for that long before it.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Less than 0.</exception>
    public int SettleTicks
    {
        get => _settleTicks;
        init =>
            _settleTicks = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(SettleTicks), value, "Ticks are 0 or more.");
    }

    /// <summary>
    /// Whether the world moves only by the steps that the client requests, from the beginning on, so that the same messages lead to
    /// the same frames. The caller advances the world only while <see cref="DrivingSession.IsStepping"/> is true.
    /// </summary>
    public bool IsLockStep { get; init; }

    /// <summary>
    /// Whether a frame of the running world is sent only when the client has answered the last one, and then at once, so that none is
    /// replaced on its way: for recordings. Otherwise the newest frame waits for the answer.
    /// </summary>
    public bool WaitsForAnswers { get; init; }

    private static double Positive(double value, string name) =>
        value > 0 && !double.IsInfinity(value)
            ? value
            : throw new ArgumentOutOfRangeException(name, value, $"{name} must be greater than 0.");
}
