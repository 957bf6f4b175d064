namespace Harvester.Datasets.Exports.Formats.Cityscapes;

/// <summary>A row of the benchmark's table of labels.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Id">Its number.</param>
/// <param name="TrainId">Its number for training; 255 for labels that are not trained on.</param>
/// <param name="HasInstances">Whether objects of this label have instance numbers.</param>
internal sealed record CityscapesLabel(string Name, ushort Id, ushort TrainId, bool HasInstances);
