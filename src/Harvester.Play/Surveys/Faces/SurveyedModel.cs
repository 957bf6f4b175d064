using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Surveys.Faces;

/// <summary>A model that a survey measures, with what is known about it.</summary>
/// <param name="Name">The model's name in lower case.</param>
/// <param name="Class">Sign or traffic light.</param>
/// <param name="SignName">What the sign says; empty if unknown.</param>
/// <param name="MutcdCode">Code of the sign; empty if it has none or it is unknown.</param>
public sealed record SurveyedModel(string Name, ObjectClass Class, string SignName, string MutcdCode)
{
    /// <summary>Its faces in the known table; those that rays cannot find are kept.</summary>
    public IReadOnlyList<ModelFace> Known { get; init; } = [];
}
