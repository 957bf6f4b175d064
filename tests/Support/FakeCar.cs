using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.TestSupport;

/// <summary>A car that records its controls.</summary>
internal sealed class FakeCar : IDrivenCar
{
    public bool IsTakenByPlayer { get; set; }

    /// <summary>The controls of each tick in which it was driven.</summary>
    public List<DrivingControls> Driven { get; } = [];

    public List<(Vector3D Position, double HeadingDegrees)> Resets { get; } = [];

    public List<(string? Weather, TimeSpan? TimeOfDay)> Environments { get; } = [];

    /// <summary>Called before each of its calls; throws to make it fail.</summary>
    public Action OnCall { get; set; } = static () => { };

    public void Drive(DrivingControls controls)
    {
        OnCall();
        Driven.Add(controls);
    }

    public void Reset(Vector3D position, double headingDegrees)
    {
        OnCall();
        Resets.Add((position, headingDegrees));
    }

    public void SetEnvironment(string? weather, TimeSpan? timeOfDay)
    {
        OnCall();
        if (weather == "hail")
        {
            throw new ArgumentException("There is no weather 'hail'.", nameof(weather));
        }

        Environments.Add((weather, timeOfDay));
    }
}
