namespace Harvester.Datasets.Exports;

/// <summary>The source of a frame.</summary>
/// <param name="Session">Number of the session in the export, from 0.</param>
/// <param name="Frame">Number of the frame in the session, from 0.</param>
public readonly record struct FramePlace(int Session, int Frame);
