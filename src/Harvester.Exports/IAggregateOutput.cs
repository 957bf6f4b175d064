namespace Harvester.Exports;

/// <summary>An aggregate file that is being written, and what its sections are made of.</summary>
internal interface IAggregateOutput
{
    /// <summary>The file as text.</summary>
    TextWriter Text { get; }

    /// <summary>The file as bytes, after all text so far.</summary>
    Stream Bytes { get; }

    /// <summary>The parts of a name, in the order of the frames.</summary>
    IEnumerable<string> Parts(string name);

    /// <summary>The content of a staged file.</summary>
    byte[] Staged(string path);

    /// <summary>Path of a staged file, for a program that reads it.</summary>
    string PathOfStaged(string path);

    /// <summary>Path of a file beside the staged ones, which a program may write.</summary>
    string WorkingFile { get; }

    /// <summary>Writes the content of a staged file.</summary>
    void CopyStaged(string path);
}
