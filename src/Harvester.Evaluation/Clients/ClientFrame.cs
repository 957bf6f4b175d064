using Harvester.Driving.Controllers;
using Harvester.Geometry;

namespace Harvester.Evaluation.Clients;

/// <summary>What a frame of a bridge tells a client, but for the picture.</summary>
/// <param name="Frame">Its number.</param>
/// <param name="TimeSeconds">The game's time, seconds.</param>
/// <param name="State">What a controller drives by.</param>
/// <param name="Position">Where the car is, metres, world; null where the bridge does not tell.</param>
public sealed record ClientFrame(long Frame, double TimeSeconds, DrivingState State, Vector3D? Position);
