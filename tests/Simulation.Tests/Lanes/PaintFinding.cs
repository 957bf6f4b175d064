namespace Harvester.Simulation.Tests.Lanes;

/// <summary>What a picture shows where a marking is labelled.</summary>
/// <param name="Kind">What is there.</param>
/// <param name="OffsetPixels">From the labelled point to the middle of the paint, square to the line as it is seen, pixels of the
/// picture.</param>
internal readonly record struct PaintFinding(PaintFindingKind Kind, double OffsetPixels = 0);
