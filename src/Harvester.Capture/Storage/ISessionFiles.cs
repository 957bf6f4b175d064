using System;
using System.IO;

namespace Harvester.Capture.Storage;

/// <summary>A session's files. What a call that fails had begun leaves no trace in files that were whole before.</summary>
internal interface ISessionFiles : IDisposable
{
    /// <summary>Makes a folder of the session if it is not there.</summary>
    void MakeFolder(string name);

    /// <summary>Writes a whole file under a temporary name and gives it its own when it is complete.</summary>
    void WriteWhole(string name, Action<Stream> content);

    /// <summary>Adds a line to labels.jsonl, all of it or nothing.</summary>
    void AppendLabel(string line);
}
