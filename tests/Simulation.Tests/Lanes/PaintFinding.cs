namespace Harvester.Simulation.Tests.Lanes;

/// <summary>What a picture shows where a marking is labelled.</summary>
/// <param name="Kind">What is there.</param>
/// <param name="OffsetPixels">From the labelled point across the line to the middle of the paint, pixels of the picture.</param>
internal readonly record struct PaintFinding(PaintFindingKind Kind, double OffsetPixels = 0);
