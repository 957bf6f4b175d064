using Harvester.Geometry;

namespace Harvester.Simulation.Models;

/// <summary>A lamp of a vehicle: a box of glass on its body.</summary>
/// <param name="Kind">What it says.</param>
/// <param name="Min">Rear, left, lower corner in the model's frame, metres.</param>
/// <param name="Max">Front, right, upper corner, metres.</param>
internal readonly record struct VehicleLamp(LampKind Kind, Vector3D Min, Vector3D Max);
