namespace Harvester.Exports.Maps;

/// <summary>A value along a road from a station on: a + b ds.</summary>
/// <param name="Station">Metres along the road's line.</param>
/// <param name="Value">The value there.</param>
/// <param name="Slope">Its change per metre.</param>
internal readonly record struct OpenDrivePiece(double Station, double Value, double Slope);
