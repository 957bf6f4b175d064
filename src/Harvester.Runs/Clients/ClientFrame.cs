using Harvester.Driving.Controllers;
using Harvester.Geometry;

namespace Harvester.Runs.Clients;

/// <summary>The data of a frame of a bridge, without the image.</summary>
/// <param name="Frame">Frame number.</param>
/// <param name="TimeSeconds">Game time, seconds.</param>
/// <param name="State">The input of a controller.</param>
/// <param name="Position">Position of the car, world, metres; null if the bridge does not send it.</param>
public sealed record ClientFrame(long Frame, double TimeSeconds, DrivingState State, Vector3D? Position);
