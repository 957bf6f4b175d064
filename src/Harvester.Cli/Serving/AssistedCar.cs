using System;
using Harvester.Capture.Driving;
using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Cli.Serving;

/// <summary>
/// The simulated car, driven by the peer where the lanes are known. In junctions, where the indicators say nothing, and where somebody comes
/// first, its own driver follows its route, as long as a peer is there.
/// </summary>
/// <param name="car">The car.</param>
/// <param name="status">How the drive stands.</param>
/// <param name="mustGiveWay">Whether the car has to stop at a line ahead, which no indicator shows.</param>
internal sealed class AssistedCar(IDrivenCar car, Func<DrivingStatus> status, Func<bool> mustGiveWay) : IDrivenCar
{
    public bool IsTakenByPlayer => car.IsTakenByPlayer;

    public void Drive(DrivingControls controls)
    {
        DrivingStatus now = status();
        if (!now.IsPeerAlive || (now.AreLanesKnown && !mustGiveWay()))
        {
            car.Drive(controls);
        }
    }

    public void Reset(Vector3D position, double headingDegrees) => car.Reset(position, headingDegrees);

    public void SetEnvironment(string? weather, TimeSpan? timeOfDay) => car.SetEnvironment(weather, timeOfDay);
}
