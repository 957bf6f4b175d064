namespace Harvester.Capture.Harvesting;

/// <summary>How much two pictures differ in the means of their blocks, grey levels of 255.</summary>
/// <param name="Greatest">The greatest absolute difference.</param>
/// <param name="Mean">The mean absolute difference.</param>
internal readonly record struct BlockDifference(double Greatest, double Mean);
