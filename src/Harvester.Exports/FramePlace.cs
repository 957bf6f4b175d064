namespace Harvester.Exports;

/// <summary>The source of a frame.</summary>
/// <param name="Session">Number of the session in the export, from 0.</param>
/// <param name="Place">Number of the place that the session visits, from 0; 0 if it visits none.</param>
/// <param name="Frame">Number of the frame in the session, from 0, counted over the frames of the same view.</param>
public readonly record struct FramePlace(int Session, int Place, int Frame);
