namespace Harvester.Datasets.Masks;

/// <summary>What an import of masks did.</summary>
/// <param name="Frames">Frames that have their mask from it now.</param>
/// <param name="Objects">Labels of objects in them.</param>
/// <param name="Seen">Those that have a pixel in their mask.</param>
public sealed record MaskImport(int Frames, int Objects, int Seen);
