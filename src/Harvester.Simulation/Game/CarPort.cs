using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Simulation.Game;

/// <summary>
/// The simulated ego as a driven car. There is no player to take over; in a tick without controls, its built-in driver follows its route,
/// through junctions too.
/// </summary>
internal sealed class CarPort(SimulatedGame game) : IDrivenCar
{
    public bool IsTakenByPlayer => false;

    public void Drive(DrivingControls controls) => game.World.Car.Drive(controls);

    public void Reset(Vector3D position, double headingDegrees) => game.ResetEgo(position, headingDegrees);

    public void SetEnvironment(string? weather, TimeSpan? timeOfDay) => game.SetEnvironment(weather, timeOfDay);
}
