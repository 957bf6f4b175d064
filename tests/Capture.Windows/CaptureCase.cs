namespace Harvester.Capture.Windows;

/// <summary>One claim about the capture of windows, and what shows it.</summary>
/// <param name="Name">The claim.</param>
/// <param name="Run">Throws when the claim is false.</param>
internal sealed record CaptureCase(string Name, Action Run);
