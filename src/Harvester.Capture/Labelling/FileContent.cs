using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Capture.Labelling;

/// <summary>Writes the content of a frame's file. It is called from the thread that writes the session.</summary>
/// <param name="stream">The file.</param>
/// <param name="png">Encodes maps.</param>
public delegate void FileContent(Stream stream, PngEncoder png);
