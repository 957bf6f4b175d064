namespace Harvester.ImageLibraries;

/// <summary>A library that decodes images.</summary>
internal interface IImageLibrary
{
    /// <summary>Its name, for the table.</summary>
    string Name { get; }

    /// <summary>Decodes a file to rows of red, green and blue, 8 bits each.</summary>
    byte[] Decode(byte[] file);

    /// <summary>Whether an exception is the one by which the library refuses a file.</summary>
    bool IsRefusal(Exception exception);
}
