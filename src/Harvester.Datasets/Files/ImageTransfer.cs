namespace Harvester.Datasets.Files;

/// <summary>How images come from a session into a dataset. The dataset's bytes are the same either way.</summary>
public enum ImageTransfer
{
    /// <summary>A second name for the same file where the file system can do that, else a copy.</summary>
    Link,

    /// <summary>A copy.</summary>
    Copy,
}
