namespace Harvester.Datasets.Files;

/// <summary>How images get from a session into a dataset. The bytes of the dataset are the same either way.</summary>
public enum ImageTransfer
{
    /// <summary>As hard links where the file system supports them, otherwise as copies.</summary>
    Link,

    /// <summary>As copies.</summary>
    Copy,
}
