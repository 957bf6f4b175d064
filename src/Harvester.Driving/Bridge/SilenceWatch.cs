using Harvester.Capture.Ports;

namespace Harvester.Driving.Bridge;

/// <summary>Holds the last controls while the client speaks, and the brake when it has been silent too long.</summary>
/// <param name="clock">The clock that silence is measured with.</param>
/// <param name="patienceSeconds">How long controls hold, seconds.</param>
public sealed class SilenceWatch(IClock clock, double patienceSeconds = SilenceWatch.DefaultPatienceSeconds)
{
    /// <summary>Half a second: five missed frames at ten a second.</summary>
    public const double DefaultPatienceSeconds = 0.5;

    private DrivingControls _controls = DrivingControls.Stop;
    private double? _heardMilliseconds;

    /// <summary>Whether the client has spoken lately.</summary>
    public bool IsClientAlive =>
        _heardMilliseconds is { } heard && clock.Milliseconds - heard <= patienceSeconds * 1000;

    /// <summary>What the car is to do now.</summary>
    public DrivingControls Controls => IsClientAlive ? _controls : DrivingControls.Stop;

    /// <summary>Sets new controls, which hold from now on.</summary>
    public void Hear(DrivingControls controls)
    {
        _controls = controls;
        _heardMilliseconds = clock.Milliseconds;
    }

    /// <summary>Forgets the client, as after a change of driver: the brake until it speaks again.</summary>
    public void Forget() => _heardMilliseconds = null;
}
