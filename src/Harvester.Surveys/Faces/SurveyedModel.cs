using System.Collections.Generic;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Surveys.Faces;

/// <summary>A model that a survey measures, with what is known of it beforehand.</summary>
/// <param name="Name">The model's name, small letters.</param>
/// <param name="Class">Sign or traffic light.</param>
/// <param name="SignName">What the sign says; empty when unknown.</param>
/// <param name="MutcdCode">Code of the sign; empty when it has none or it is unknown.</param>
public sealed record SurveyedModel(string Name, ObjectClass Class, string SignName, string MutcdCode)
{
    /// <summary>Its faces as a table has them; those that rays cannot find are kept.</summary>
    public IReadOnlyList<ModelFace> Known { get; init; } = [];
}
