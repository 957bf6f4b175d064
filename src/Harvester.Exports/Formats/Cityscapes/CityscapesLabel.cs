namespace Harvester.Exports.Formats.Cityscapes;

/// <summary>A row of the benchmark's label table.</summary>
/// <param name="Name">Name of the label.</param>
/// <param name="Id">Id of the label.</param>
/// <param name="TrainId">Id for training; 255 for labels that are not trained on.</param>
/// <param name="HasInstances">Whether objects of this label have instance ids.</param>
internal sealed record CityscapesLabel(string Name, ushort Id, ushort TrainId, bool HasInstances);
