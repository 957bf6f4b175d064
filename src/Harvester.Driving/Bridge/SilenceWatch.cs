using Harvester.Capture.Ports;

namespace Harvester.Driving.Bridge;

/// <summary>Holds the last controls while the client sends messages, and brakes when it has been silent too long.</summary>
/// <param name="clock">The clock that measures the silence.</param>
/// <param name="patienceSeconds">How long controls hold, seconds.</param>
public sealed class SilenceWatch(IClock clock, double patienceSeconds = SilenceWatch.DefaultPatienceSeconds)
{
    /// <summary>Half a second: five missed frames at 10 frames per second.</summary>
    public const double DefaultPatienceSeconds = 0.5;

    private DrivingControls _controls = DrivingControls.Stop;
    private double? _heardMilliseconds;

    /// <summary>Whether the client has sent controls recently.</summary>
    public bool IsClientAlive => _heardMilliseconds is { } heard && clock.Milliseconds - heard <= patienceSeconds * 1000;

    /// <summary>The controls to apply now.</summary>
    public DrivingControls Controls => IsClientAlive ? _controls : DrivingControls.Stop;

    /// <summary>Sets new controls, which hold from now on.</summary>
    public void Receive(DrivingControls controls)
    {
        _controls = controls;
        _heardMilliseconds = clock.Milliseconds;
    }

    /// <summary>Discards the last controls, as after a change of driver: the car brakes until new controls come.</summary>
    public void Reset() => _heardMilliseconds = null;
}
